#include <algorithm>
#include <cmath>

#include "mariotte/flow/flows.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"

namespace mariotte::flow {

using taylor::Piece;
using taylor::PieceStep;
using taylor::Window;

namespace {

/// A contact that creeps is left to BDF: explicit steps must not outrun its fastest decay. So many are tried
/// where BDF has begun with no longer steps: it may have had to find its way.
constexpr Index patience = 300'000;

bool is_finite(const Window& w) {
  double sum = 0;  // without a branch for each
  for (const double v : w.velocity) sum += v - v;
  return sum == 0;
}

/// A contact may have left the noise, on either side, or sunk into it, or its load has, or one that adheres
/// has come to rest without a turn: the problem is to say.
bool concerns_problem(const Window& w, const taylor::Values& values) {
  const auto& l = w.lanes;
  bool any = false;
  for (int j = 0; values.may_change && j < l.count; ++j) {
    any |= l.indentation[j] < l.fades_below[j] && std::abs(l.rate[j]) <= w.fade_speed;
    any |= std::abs(l.indentation[j]) > l.leaves_noise[j];
  }
  for (int j = 0; l.damped && j < l.count; ++j) {
    any |= w.contact(j).role == Role::closed && has_faint_load(w, j);
    any |= l.branched && l.turn_side[j] != 0 && std::abs(l.rate[j]) <= l.turn_level[j];
  }
  return any;
}

/// Branches that are no powers have a series of their own, from the start of a contact on: either all
/// contacts that push have one, or none. That series has no powers of other depths.
bool are_alike(const std::vector<PhaseContact>& contacts) {
  const auto count = [&](auto&& is_one) { return std::count_if(contacts.begin(), contacts.end(), is_one); };
  const auto wide = count([](const PhaseContact& c) { return c.pushes() && c.width; });
  if (wide == 0) return true;
  if (wide < count([](const PhaseContact& c) { return c.pushes(); })) return false;
  return count([](const PhaseContact& c) {
           return (c.role == Role::touching && c.width) ||
                  (c.role == Role::slack && c.damping > 0 && c.grows == Damping::as_root);
         }) == 0;
}

class Taylor final : public Flow {
 public:
  bool fits(const Problem& problem) const override { return !problem.tip() && !problem.recorded(); }
  bool admits(const Problem& problem) override;
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  taylor::Stepper stepper_;
  Index steps_ = 0;
  Simultaneous simultaneous_;
  std::vector<double> before_, after_;
  taylor::Values scratch_;

  std::optional<Arrival> step(Problem& problem, State x, const Request& request, taylor::Fall& fall,
                              std::vector<Index>& fired);

  Arrival stop(State x, Outcome outcome, std::string message = {}) const {
    const auto& w = stepper_.window;
    write(w, x);
    return {outcome, w.time, steps_, steps_, std::move(message)};
  }

  void show(const Piece& piece, StepObserver& observer) {
    const auto& window = stepper_.window;
    before_.resize(window.x.size());
    after_.resize(window.x.size());
    write(window, before_);
    write(window, stepper_.values(), after_);
    PieceStep step(window, piece, stepper_.values().time, scratch_);
    step.start = window.time;
    step.end = window.time + stepper_.values().time;
    step.before = before_;
    step.after = after_;
    observer.observe(step);
  }

  void advance(const Piece& piece, const Request& request) {
    if (request.observer) show(piece, *request.observer);
    stepper_.advance(piece);
  }

  /// State at the event that ends the phase: `fall`, or the contact outside that the window cannot pass.
  void finish(const Problem& problem, const taylor::Fall& fall, double accuracy, State x,
              std::vector<Index>& fired) {
    const auto& w = stepper_.window;
    write(w, x);
    fired.push_back(fall.guard < 0 ? w.outside_guard : fall.guard);
    if (fall.guard < 0 && w.outside) x[w.outside->gap] = 0 - w.outside->level;
    const double together = simultaneity_window(problem, accuracy);
    if (stepper_.may_fall_soon(fall, together)) simultaneous_.collect(problem, x, together, fired);
  }

  /// An undamped contact has opened, and the phase goes on without it: nothing is placed anew.
  bool passes(const Problem& problem, const taylor::Fall& fall, const Request& request) {
    auto& w = stepper_.window;
    if (!request.events || fall.guard < 0 || w.drives || w.is_pulled || w.lanes.damped || w.lanes.branched)
      return false;
    if (!w.has_root(fall.lane) || fall.guard != w.contact(fall.lane).guard) return false;
    if (stepper_.may_fall_soon(fall, simultaneity_window(problem, request.accuracy))) return false;
    if (!request.events->take(fall.guard, w.time, w.lanes.rate[fall.lane])) return false;
    watch(w, fall.lane);
    return true;
  }

  Accepted accept(Problem& problem) {
    auto& window = stepper_.window;
    if (!concerns_problem(window, stepper_.values())) return Accepted::unchanged;
    after_.resize(window.x.size());
    write(window, after_);
    const auto accepted = problem.accept(after_);
    if (accepted != Accepted::rewatched) return accepted;
    for (int j = 0; j < window.lanes.count; ++j)
      if (window.lanes.leaves_noise[j] < infinity && window.contact(j).role != Role::touching)
        watch(window, j);
    return accepted;
  }
};

bool Taylor::admits(const Problem& problem) {
  if (const auto* row = problem.serial()) return are_alike(row->contact);
  const auto* linked = problem.linked();
  return linked && !may_pull(*linked) && are_alike(linked->contact);
}

Arrival Taylor::follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) {
  const auto& w = stepper_.window;
  auto precision = taylor::precision(resolving_accuracy(problem, request.accuracy, 0));
  precision.has_slopes = request.observer && request.observer->has_slopes();
  stepper_.stride = 0.1 * problem.time_scale();
  stepper_.begin(problem, x, 0, precision);
  for (steps_ = 0; steps_ < most_steps_of_phase;) {
    taylor::Fall fall;
    if (auto arrival = step(problem, x, request, fall, fired)) return *arrival;
    if (has_outgrown(w) || (fall.guard >= 0 && has_shrunk(w))) {
      write(w, x);
      stepper_.begin(problem, x, w.time, precision);
    }
  }
  auto arrival = stop(x, Outcome::failed, exhaustion);
  arrival.exhausted = true;
  return arrival;
}

std::optional<Arrival> Taylor::step(Problem& problem, State x, const Request& request, taylor::Fall& fall,
                                    std::vector<Index>& fired) {
  const auto& w = stepper_.window;
  auto piece = stepper_.next(steps_ == 0, std::min(request.limit, w.outside_time) - w.time);
  fall = stepper_.first_fall(piece);
  const bool ends = fall.guard >= 0 || piece.is_cut;  // perhaps at once: a contact at zero that parts
  if (!(piece.end > 0) && !ends) return stop(x, Outcome::failed, "the series does not converge");
  ++steps_;
  advance(piece, request);
  if (!is_finite(w)) return stop(x, Outcome::failed, "a velocity is not finite");
  if (stepper_.is_late()) return stop(x, Outcome::failed, "a contact was left out for too long");
  const bool cut = fall.guard < 0 && piece.is_cut;
  if (cut && request.limit <= w.outside_time) return stop(x, Outcome::limit);
  if (ends && !passes(problem, fall, request)) {
    finish(problem, fall, request.accuracy, x, fired);
    return Arrival{Outcome::guard, w.time, steps_, steps_, {}};
  }
  if (accept(problem) == Accepted::ended) return stop(x, Outcome::guard);
  if (!w.lanes.damped || steps_ < (request.patient ? patience : request.most_steps)) return std::nullopt;
  auto arrival = stop(x, Outcome::stiff);
  arrival.resumable = !request.patient;
  return arrival;
}

}  // namespace

std::unique_ptr<Flow> make_taylor_flow() {
  return std::make_unique<Taylor>();
}

}  // namespace mariotte::flow
