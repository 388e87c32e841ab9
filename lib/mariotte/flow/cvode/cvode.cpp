#include "mariotte/flow/cvode/cvode.hpp"

#include <sundials/sundials_version.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "mariotte/core/counted.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/flow/cvode/linear_solver.hpp"
#include "mariotte/flow/flows.hpp"
#include "mariotte/flow/roots/certificate.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::flow {
namespace {

/// Local tolerance for a wanted global error. Measured on the reference chains (tests/flow, convergence):
/// Adams turns a local tolerance into an error 10 to 300 times as large, BDF 100 to 1000 times. What BDF is
/// used for is stiff: rates are wrong by many roundings, and a tolerance near one would never be met.
double local_tolerance(Kind kind, double accuracy, double swiftness) {
  if (kind == Kind::cvode_adams) return std::max(3e-4 * accuracy, 4 * epsilon);
  return std::max(1e-4 * accuracy, std::max(64.0, 4 * swiftness) * epsilon);
}

/// Accuracy beyond which creeping contacts are not resolved: CVODE's errors begin there.
constexpr double finest = 1e-12;

/// A phase whose clock stands still so often is not going anywhere.
constexpr Index stall_limit = 100;
/// Steps after which their average tells whether this flow is the quicker one.
constexpr Index trial = 2000;
/// Steps for which a Jacobian is kept where the matrix is made anew. CVODE's 51 are too many for a slip in
/// space that leaves rest: friction turns at a rate that falls like the inverse of its speed. Newton's first
/// correction by an old Jacobian is then wrong, and passes for converged by what earlier steps had promised.
constexpr Index jacobian_age = 1;
/// Of so many steps BDF repeats few while it can meet its tolerance, and half of them where that is below
/// what rounding makes of rates: those of a contact that rests under strong damping follow its depth at once.
/// There the tolerance is eased, up to a share of the accuracy.
constexpr Index refusals_counted = 100, most_refusals = 40;
constexpr double easing = 4, most_eased = 0.1;
/// Attempts at one step. Each is up to ten times shorter: where a force begins like a small power of the
/// indentation, the first must be very short.
constexpr int most_rejections = 40;

State view(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<std::size_t>(N_VGetLength_Serial(v))};
}
bool all_finite(ConstState values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}
void check(int code, const char* what) {
  if (code < 0) throw Error(std::string("SUNDIALS refused ") + what);
}

class Cvode final : public Flow {
 public:
  Cvode(Kind kind, const Problem& like) : kind_(kind), roots_(like.guard_count()) {
    state_.reset(N_VNew_Serial(like.size(), context_));
    dense_.reset(N_VNew_Serial(like.size(), context_));
    N_VConst(0, state_.get());
    cvode_.reset(CVodeCreate(kind == Kind::cvode_adams ? CV_ADAMS : CV_BDF, context_));
    check(CVodeInit(cvode_.get(), derivative, 0, state_.get()), "the problem");
    check(CVodeSetUserData(cvode_.get(), this), "user data");
    check(sundials::send_messages(context_, cvode_.get(), complaint_), "an error handler");
    check(CVodeWFtolerances(cvode_.get(), weights), "the weights");
    check(CVodeSetMaxNumSteps(cvode_.get(), most_steps_of_phase), "the step limit");
    check(CVodeRootInit(cvode_.get(), static_cast<int>(like.guard_count()), guards), "the guards");
    check(CVodeSetMaxErrTestFails(cvode_.get(), most_rejections), "the number of rejections");
    check(CVodeSetNoInactiveRootWarn(cvode_.get()), "quiet roots");
    attach_solver(like);
  }
  bool fits(const Problem& problem) const override {
    return problem.size() == N_VGetLength_Serial(state_.get()) &&
           problem.guard_count() == static_cast<Index>(roots_.size()) && (!newton_ || newton_->fits(problem));
  }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override {
    restart(problem, x, request);
    const auto dense = [this](double time, State there) {  // CVODE's own interpolating polynomial
      CVodeGetDky(cvode_.get(), time, 0, dense_.get());
      const auto values = view(dense_.get());
      std::copy(values.begin(), values.end(), there.begin());
    };
    StepOf step(dense);
    Index stalled = 0;
    for (Index count = 0; count < most_steps_of_phase && stalled < stall_limit; ++count) {
      step.start = step.end;
      const int code =
          CVode(cvode_.get(), step.start + problem.time_scale(), state_.get(), &step.end, CV_ONE_STEP);
      if (code < 0) return fail(code, step.start, x);
      auto outcome = find_end(code, step, request, fired);
      accept(step, request, outcome, fired);
      if (outcome) return finish(*outcome, step.end, x);
      before_.assign(step.after.begin(), step.after.end());
      if (count % refusals_counted == 0) ease(count, request.accuracy);
      stalled += step.end - step.start <= 2 * epsilon * step.end;
      if (auto arrival = give_way(count, step.end, request, x)) return *arrival;
    }
    auto arrival = fail(stalled == stall_limit ? "the step has shrunk to nothing" : exhaustion, step.end, x);
    arrival.exhausted = stalled < stall_limit;
    return arrival;
  }

 private:
  Kind kind_;
  sundials::Context context_;
  sundials::Vector state_, dense_;
  sundials::NonlinearSolver fixed_point_;
  std::optional<NewtonMatrix> newton_;
  sundials::Cvode cvode_;
  Problem* problem_ = nullptr;
  double tolerance_ = 0;
  long refused_ = 0;       ///< attempts at steps, when they were counted last
  std::string complaint_;  ///< SUNDIALS' last message
  std::vector<double> before_;
  std::vector<int> roots_;
  Certificate certificate_;
  Simultaneous simultaneous_;

  void attach_solver(const Problem& like) {
    if (kind_ == Kind::cvode_adams) {
      fixed_point_.reset(SUNNonlinSol_FixedPoint(state_.get(), 0, context_));
      check(CVodeSetNonlinearSolver(cvode_.get(), fixed_point_.get()), "fixed-point iteration");
      return;
    }
    newton_.emplace(kind_, like, state_.get(), context_);
    check(CVodeSetLinearSolver(cvode_.get(), newton_->solver(), newton_->matrix()), "the linear solver");
    check(CVodeSetJacFn(cvode_.get(), jacobian), "the Jacobian");
    check(CVodeSetJacEvalFrequency(cvode_.get(), jacobian_age), "the age of the Jacobian");
  }

  // Callbacks: a value that is not finite must never pass for a result.
  static int derivative(sunrealtype, N_Vector x, N_Vector dx, void* self) {
    static_cast<Cvode*>(self)->problem_->derivative(view(x), view(dx));
    return all_finite(view(dx)) ? 0 : 1;
  }
  static int guards(sunrealtype, N_Vector x, sunrealtype* values, void* self) {
    const auto& problem = *static_cast<Cvode*>(self)->problem_;
    const State out(values, problem.guard_count());
    problem.guards(view(x), out);
    return all_finite(out) ? 0 : -1;
  }
  static int jacobian(sunrealtype, N_Vector x, N_Vector, SUNMatrix j, void* self, N_Vector, N_Vector,
                      N_Vector) {
    auto& flow = *static_cast<Cvode*>(self);
    return flow.newton_->fill(*flow.problem_, view(x), j) ? 0 : 1;
  }
  /// CVODE bounds the root mean square of error × weight; the factor √n makes that a bound on the largest.
  /// The term with epsilon keeps the demand above rounding.
  static int weights(N_Vector x, N_Vector weight, void* self) {
    const auto& flow = *static_cast<Cvode*>(self);
    const auto magnitudes = flow.problem_->magnitudes();
    const auto values = view(x);
    const auto out = view(weight);
    const double share = flow.tolerance_ / std::sqrt(static_cast<double>(out.size()));
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = 1 / (share * magnitudes[i] + 8 * epsilon * std::abs(values[i]));
    return 0;
  }

  void restart(Problem& next, State x, const Request& request) {
    problem_ = &next;
    tolerance_ =
        local_tolerance(kind_, resolving_accuracy(next, request.accuracy, finest), next.swiftness(x));
    complaint_.clear();
    refused_ = 0;
    std::copy(x.begin(), x.end(), view(state_.get()).begin());
    check(CVodeReInit(cvode_.get(), 0, state_.get()), "a restart");
    // At an onset the force starts from zero and fools the automatic first step.
    check(CVodeSetInitStep(cvode_.get(), 0.1 * std::sqrt(tolerance_) * next.time_scale()), "the first step");
    const auto crossings = next.crossings();
    std::transform(crossings.begin(), crossings.end(), roots_.begin(),
                   [](Crossing c) { return static_cast<int>(c); });
    check(CVodeSetRootDirection(cvode_.get(), roots_.data()), "the directions of the guards");
    before_.assign(x.begin(), x.end());
    certificate_.begin(next, x);
  }
  /// What ends the step: a guard, also one that CVODE has passed over, or the limit.
  std::optional<Outcome> find_end(int code, flow::Step& step, const Request& request,
                                  std::vector<Index>& fired) {
    auto outcome = code == CV_ROOT_RETURN ? std::optional(Outcome::guard) : std::nullopt;
    if (step.end >= request.limit) {
      move_to(step.end = request.limit);
      outcome = Outcome::limit;
    }
    step.before = before_;
    step.after = view(state_.get());
    if (const auto hidden = certificate_.examine(*problem_, step)) {
      move_to(step.end = hidden->time);
      fired.push_back(hidden->guard);
      return Outcome::guard;
    }
    if (outcome == Outcome::guard) append_roots(fired);
    return outcome;
  }
  /// Tells the observer and the problem of the step, which may end the mode.
  void accept(const flow::Step& step, const Request& request, std::optional<Outcome>& outcome,
              std::vector<Index>& fired) {
    auto& problem = *problem_;
    if (request.observer) request.observer->observe(step);
    if (outcome == Outcome::guard)
      simultaneous_.collect(problem, step.after, simultaneity_window(problem, request.accuracy), fired);
    const auto accepted = problem.accept(step.after);
    if (accepted == Accepted::rewatched) certificate_.begin(problem, step.after);
    if (accepted == Accepted::ended && !outcome) outcome = Outcome::guard;
  }
  /// To another flow, which may be quicker. A slip in space of two tips that friction holds near zero is
  /// stiff, whatever the damping.
  std::optional<Arrival> give_way(Index count, double time, const Request& request, State x) {
    if (count == trial && time < trial * request.least_step) return finish(Outcome::stiff, time, x);
    const bool is_long = count == std::min(request.most_steps, problem_->trial_steps());
    if (!is_long || kind_ != Kind::cvode_adams || request.patient) return std::nullopt;
    auto arrival = finish(Outcome::stiff, time, x);
    arrival.resumable = true;
    return arrival;
  }
  void ease(Index steps, double accuracy) {
    long inexact = 0, unsolved = 0;
    check(CVodeGetNumErrTestFails(cvode_.get(), &inexact), "its counts");
    check(CVodeGetNumNonlinSolvConvFails(cvode_.get(), &unsolved), "its counts");
    const long before = std::exchange(refused_, inexact + unsolved);
    if (kind_ == Kind::cvode_adams || steps == 0 || refused_ - before <= most_refusals) return;
    tolerance_ = std::max(tolerance_, std::min(easing * tolerance_, most_eased * accuracy));
  }
  void append_roots(std::vector<Index>& fired) {
    check(CVodeGetRootInfo(cvode_.get(), roots_.data()), "root information");
    for (std::size_t i = 0; i < roots_.size(); ++i)
      if (roots_[i] != 0) fired.push_back(static_cast<Index>(i));
  }

  /// "velocity 3, gap 2": the components with the largest share of the local error.
  std::string worst_components() const {
    sundials::Vector error(N_VClone(state_.get())), weight(N_VClone(state_.get()));
    CVodeGetEstLocalErrors(cvode_.get(), error.get());
    CVodeGetErrWeights(cvode_.get(), weight.get());
    const auto e = view(error.get()), w = view(weight.get());
    std::vector<Index> order(e.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
    const auto count = std::min<std::size_t>(3, order.size());
    std::partial_sort(order.begin(), order.begin() + count, order.end(),
                      [&](Index a, Index b) { return std::abs(e[a] * w[a]) > std::abs(e[b] * w[b]); });
    std::string names;
    for (std::size_t i = 0; i < count; ++i) names += (i ? ", " : "") + problem_->component(order[i]);
    return names;
  }

  Arrival finish(Outcome outcome, double time, State x, std::string message = {}) {
    const auto values = view(state_.get());
    std::copy(values.begin(), values.end(), x.begin());
    long steps = 0, rhs = 0;
    CVodeGetNumSteps(cvode_.get(), &steps);
    CVodeGetNumRhsEvals(cvode_.get(), &rhs);
    return {outcome, time, steps, rhs, std::move(message)};
  }
  Arrival fail(const std::string& reason, double time, State x) {
    std::string message = reason + " at local time " + std::to_string(time) + " after ";
    auto arrival = finish(Outcome::failed, time, x);
    message += counted(arrival.steps, "step") + " (worst components: " + worst_components() + ")";
    if (!complaint_.empty()) message += "; SUNDIALS: " + complaint_;
    arrival.message = std::move(message);
    return arrival;
  }
  Arrival fail(int code, double time, State x) {
    char* raw = CVodeGetReturnFlagName(code);
    const std::string flag = raw;
    std::free(raw);
    return fail(flag, time, x);
  }
  void move_to(double time) { CVodeGetDky(cvode_.get(), time, 0, state_.get()); }
};

}  // namespace

std::unique_ptr<Flow> make_cvode_flow(Kind kind, const Problem& like) {
  return std::make_unique<Cvode>(kind, like);
}

std::string sundials_version() {
  char version[32] = "";
  SUNDIALSGetVersion(version, sizeof version);
  return version;
}

}  // namespace mariotte::flow
