#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>
#include <memory>
#include <sundials/sundials_context.hpp>

#include "mariotte/core/error.hpp"
#include "measuring/rivals.hpp"
#include "slope_rival.hpp"

namespace mariotte::work_precision {
namespace {

constexpr long most_steps = 1'000'000;

void check(int code, const char* what) {
  if (code < 0) throw Error(std::string("CVODES: ") + what + " failed with code " + std::to_string(code));
}

/// In the order of the library: masses, velocities, gaps, and numbers of one law after the other.
struct Number {
  enum Kind { mass, velocity, gap, stiffness, damping, exponent } kind;
  std::size_t of;
};

std::vector<Number> numbers(const model::Chain& chain) {
  std::vector<Number> list;
  for (const auto kind : {Number::mass, Number::velocity})
    for (std::size_t i = 0; i < chain.mass.size(); ++i) list.push_back({kind, i});
  for (std::size_t j = 0; j < chain.gap.size(); ++j) list.push_back({Number::gap, j});
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    list.push_back({Number::stiffness, j});
    if (!(power_law(chain.law[j])->damping > 0)) continue;
    list.push_back({Number::damping, j});
    list.push_back({Number::exponent, j});
  }
  return list;
}

/// Gaps, then velocities.
class Equations {
 public:
  explicit Equations(const model::Chain& chain)
      : chain_(chain), number_(numbers(chain)), force_(contacts()) {}

  std::size_t contacts() const { return chain_.gap.size(); }
  std::size_t size() const { return contacts() + chain_.mass.size(); }
  std::size_t columns() const { return number_.size(); }

  void start(double* x) const {
    std::copy(chain_.gap.begin(), chain_.gap.end(), x);
    std::copy(chain_.velocity.begin(), chain_.velocity.end(), x + contacts());
  }
  void start_slopes(std::size_t column, double* s) const {
    std::fill(s, s + size(), 0.0);
    const auto& number = number_[column];
    if (number.kind == Number::gap) s[number.of] = 1;
    if (number.kind == Number::velocity) s[contacts() + number.of] = 1;
  }
  void rates(const double* x, double* dx) {
    find_forces(x);
    for (std::size_t j = 0; j < contacts(); ++j) dx[j] = rate_of_gap(x, j);
    for (std::size_t i = 0; i < chain_.mass.size(); ++i)
      dx[contacts() + i] = push(i, [&](std::size_t j) { return force_[j].value; }) / chain_.mass[i];
  }
  void slope_rates(const double* x, std::size_t column, const double* s, double* ds) {
    const auto& number = number_[column];
    for (std::size_t j = 0; j < contacts(); ++j) {
      ds[j] = rate_of_gap(s, j);
      slope_[j] = -force_[j].by_indentation * s[j] - force_[j].by_rate * ds[j];
      if (number.kind >= Number::stiffness && number.of == j) slope_[j] += by_number(x, number);
    }
    for (std::size_t i = 0; i < chain_.mass.size(); ++i) {
      ds[contacts() + i] = push(i, [&](std::size_t j) { return slope_[j]; }) / chain_.mass[i];
      if (number.kind == Number::mass && number.of == i)
        ds[contacts() + i] -=
            push(i, [&](std::size_t j) { return force_[j].value; }) / std::pow(chain_.mass[i], 2);
    }
  }
  void find_forces(const double* x) {
    slope_.resize(contacts());
    for (std::size_t j = 0; j < contacts(); ++j) {
      force_[j] = contact::smooth_force(*power_law(chain_.law[j]), -x[j], -rate_of_gap(x, j));
      if (!(x[j] < 0 && force_[j].value > 0)) force_[j] = {.value = 0, .by_indentation = 0, .by_rate = 0};
    }
  }

 private:
  double rate_of_gap(const double* x, std::size_t j) const {
    return x[contacts() + j + 1] - x[contacts() + j];
  }
  /// On ball i by forces of both its contacts.
  template <class Force>
  double push(std::size_t i, Force&& force) const {
    return (i > 0 ? force(i - 1) : 0) - (i < contacts() ? force(i) : 0);
  }
  double by_number(const double* x, const Number& number) const {
    const auto& f = force_[number.of];
    if (f.value == 0) return 0;
    const double depth = -x[number.of];
    const double width = contact::contact_width(power_law(chain_.law[number.of])->exponent, depth);
    if (number.kind == Number::stiffness) return width * depth;
    return number.kind == Number::damping ? -width * rate_of_gap(x, number.of) : f.value * std::log(depth);
  }

  const model::Chain& chain_;
  std::vector<Number> number_;
  std::vector<contact::Force> force_;
  std::vector<double> slope_;
};

struct Free {
  void operator()(_generic_N_Vector* v) const { N_VDestroy(v); }
  void operator()(_generic_SUNNonlinearSolver* s) const { SUNNonlinSolFree(s); }
  void operator()(void* memory) const { CVodeFree(&memory); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

class Run {
 public:
  Run(const model::Chain& chain, double tolerance) : equations_(chain) {
    const auto n = static_cast<sunindextype>(equations_.size());
    const auto columns = static_cast<int>(equations_.columns());
    state_.reset(N_VNew_Serial(n, context_));
    for (int c = 0; c < columns; ++c) {
      kept_.emplace_back(N_VNew_Serial(n, context_));
      slopes_.push_back(kept_.back().get());
    }
    start();
    cvodes_.reset(CVodeCreate(CV_ADAMS, context_));
    void* cvodes = cvodes_.get();
    check(keep_quiet(), "error handler");
    check(CVodeInit(cvodes, rates, 0, state_.get()), "start");
    check(CVodeSetUserData(cvodes, &equations_), "user data");
    check(CVodeSStolerances(cvodes, tolerance, tolerance), "tolerances");
    check(CVodeSetMaxNumSteps(cvodes, most_steps), "step limit");
    check(CVodeSetMaxStep(cvodes, measuring::longest_step), "longest step");
    fixed_point_.reset(SUNNonlinSol_FixedPoint(state_.get(), 0, context_));
    check(CVodeSetNonlinearSolver(cvodes, fixed_point_.get()), "fixed-point iteration");
    check(CVodeSensInit(cvodes, columns, CV_STAGGERED, slope_rates, slopes_.data()), "start of slopes");
    const std::vector<double> allowed(slopes_.size(), tolerance);
    check(CVodeSensSStolerances(cvodes, tolerance, const_cast<double*>(allowed.data())), "tolerances");
    check(CVodeSetSensErrCon(cvodes, true), "control of errors");
    of_slopes_.reset(SUNNonlinSol_FixedPointSens(columns, state_.get(), 0, context_));
    check(CVodeSetNonlinearSolverSensStg(cvodes, of_slopes_.get()), "fixed-point iteration of slopes");
  }
  void follow(double end) {
    start();
    check(CVodeReInit(cvodes_.get(), 0, state_.get()), "restart");
    check(CVodeSensReInit(cvodes_.get(), CV_STAGGERED, slopes_.data()), "restart of slopes");
    double time = 0;
    check(CVode(cvodes_.get(), end, state_.get(), &time, CV_NORMAL), "a step");
    check(CVodeGetSens(cvodes_.get(), &time, slopes_.data()), "slopes");
  }
  double error(const VelocitySlopes& right) const {
    double most = 0, largest = 0;
    for (std::size_t i = 0; i < right.size(); ++i)
      for (std::size_t c = 0; c < slopes_.size(); ++c) {
        const double own = NV_DATA_S(slopes_[c])[equations_.contacts() + i];
        most = std::max(most, std::abs(own - right[i][c]));
        largest = std::max(largest, std::abs(right[i][c]));
      }
    return most / largest;
  }

 private:
  int keep_quiet() {
#if SUNDIALS_VERSION_MAJOR < 7
    return CVodeSetErrHandlerFn(
        cvodes_.get(), [](int, const char*, const char*, char*, void*) {}, nullptr);
#else
    return SUNContext_ClearErrHandlers(context_);
#endif
  }
  void start() {
    equations_.start(NV_DATA_S(state_.get()));
    for (std::size_t c = 0; c < slopes_.size(); ++c) equations_.start_slopes(c, NV_DATA_S(slopes_[c]));
  }
  static int rates(sunrealtype, N_Vector x, N_Vector dx, void* equations) {
    static_cast<Equations*>(equations)->rates(NV_DATA_S(x), NV_DATA_S(dx));
    return 0;
  }
  static int slope_rates(int columns, sunrealtype, N_Vector x, N_Vector, N_Vector* s, N_Vector* ds,
                         void* self, N_Vector, N_Vector) {
    auto& equations = *static_cast<Equations*>(self);
    equations.find_forces(NV_DATA_S(x));
    for (int c = 0; c < columns; ++c)
      equations.slope_rates(NV_DATA_S(x), static_cast<std::size_t>(c), NV_DATA_S(s[c]), NV_DATA_S(ds[c]));
    return 0;
  }

  sundials::Context context_;
  Equations equations_;
  Owned<_generic_N_Vector> state_;
  std::vector<Owned<_generic_N_Vector>> kept_;
  std::vector<N_Vector> slopes_;
  Owned<_generic_SUNNonlinearSolver> fixed_point_, of_slopes_;
  Owned<void> cvodes_;
};

}  // namespace

std::optional<RivalSlopes> slopes_by_cvodes(const model::Chain& chain, double end,
                                            const VelocitySlopes& slopes, double accuracy,
                                            const measuring::Patience& patience) {
  for (double tolerance = accuracy; tolerance > 1e-15; tolerance *= 0.1) try {
      Run run(chain, tolerance);
      const auto follow = [&] { run.follow(measuring::overtime * end); };
      const double first = measuring::timed(follow);
      const double error = run.error(slopes);
      if (error <= accuracy) return RivalSlopes{measuring::least_seconds(follow, first, patience), error};
    } catch (const Error&) {
      // Slopes of a damped force are unbounded where it begins: steps may become too short.
    }
  return {};
}

}  // namespace mariotte::work_precision
