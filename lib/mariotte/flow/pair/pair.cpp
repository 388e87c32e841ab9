#include <algorithm>
#include <cmath>

#include "mariotte/flow/flows.hpp"
#include "mariotte/flow/pair/pair_phase.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::flow {
namespace {

class PairStep final : public Step {
 public:
  PairStep(const PairPhase& phase, const PairMotion& motion, ConstState origin, ConstState rate)
      : phase_(phase), motion_(motion), origin_(origin), rate_(rate) {}

  void at(double time, State x) const override {
    const auto now = std::visit([&](const auto& motion) { return motion.at(time); }, motion_);
    put(time, now, x);
  }
  ConstState origin() const { return origin_; }
  /// When the indentation is largest.
  double turn() const {
    return std::visit([](const auto& motion) { return motion.turn(); }, motion_);
  }
  void put(double time, const Indentation& now, State x) const {
    const auto& c = *phase_.contact;
    const double approach = origin_[phase_.left] - origin_[phase_.right];
    const double indentation = c.origin + now.value;
    const double deepened = indentation + origin_[c.gap], lost = approach - now.rate;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = origin_[i] + time * rate_[i];
    // As if the pair moved with its mass centre, and what it deepens.
    const auto put_gap = [&](Index gap, double share) {
      if (gap >= 0) x[gap] = origin_[gap] + time * (rate_[gap] - share * approach) + share * deepened;
    };
    put_gap(phase_.left_gap, phase_.left_share);
    put_gap(phase_.right_gap, phase_.right_share);
    x[phase_.left] = origin_[phase_.left] - phase_.left_share * lost;
    x[phase_.right] = origin_[phase_.right] + phase_.right_share * lost;
    x[c.gap] = 0 - indentation;  // never −0
    const double m = phase_.law.reduced_mass;
    if (c.work >= 0) x[c.work] = origin_[c.work] + 0.5 * m * lost * (approach + now.rate);
    if (c.impulse >= 0) x[c.impulse] = origin_[c.impulse] + m * lost;
  }

 private:
  const PairPhase& phase_;
  const PairMotion& motion_;
  ConstState origin_, rate_;
};

/// Two steps that meet at the largest indentation put the peak where a observer looks first.
void show(PairStep& step, double duration, ConstState end, StepObserver& observer) {
  std::vector<double> deepest(end.size());
  step.before = step.origin();
  if (const double turn = step.turn(); turn > 0 && turn < duration) {
    step.at(step.end = turn, deepest);
    step.after = deepest;
    observer.observe(step);
    step.before = deepest;
    step.start = turn;
  }
  step.end = duration;
  step.after = end;
  observer.observe(step);
}

/// The gap that guard i watches, as the pair moves it.
ConcaveGap concave_gap(const PairPhase& phase, Index guard, double value, double rate, double approach) {
  const double share = guard == phase.left_guard    ? phase.left_share
                       : guard == phase.right_guard ? phase.right_share
                                                    : 0;
  return {value, rate - share * approach, share};
}

class Pair final : public Flow {
 public:
  bool admits(const Problem& problem) override {
    const auto* phase = problem.drives() ? nullptr : problem.serial();
    phase_ = phase ? find_pair(*phase) : std::nullopt;
    return phase_.has_value();
  }

  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override {
    const PairPhase& phase = phase_.value();
    begin(problem, x);
    const Indentation start{-x[phase.contact->gap] - phase.contact->origin, x[phase.left] - x[phase.right]};
    const auto motion = make_pair_motion(phase.law, start);
    const auto end = first_event(problem, motion, start);
    if (!std::isfinite(end.duration)) return {.outcome = Outcome::failed, .message = "it is held together"};
    const bool limited = request.limit < end.duration;
    const double duration = limited ? request.limit : end.duration;

    PairStep step(phase, motion, start_, rate_);
    if (!limited && (end.guard == phase.guard || is_of_branch(end.guard)))
      step.put(duration, end.last, x);
    else
      step.at(duration, x);
    if (request.observer) show(step, duration, x, *request.observer);
    if (!limited) {
      fired.push_back(end.guard);
      simultaneous_.collect(problem, x, simultaneity_window(problem, request.accuracy), fired);
    }
    return {.outcome = limited ? Outcome::limit : Outcome::guard, .duration = duration, .steps = 1, .rhs = 1};
  }

 private:
  /// What ends a phase, unless a limit comes first.
  struct End {
    double duration;
    Index guard;
    Indentation last;  ///< of the pair, if its own guard ends the phase
  };
  void begin(const Problem& problem, ConstState x) {
    start_.assign(x.begin(), x.end());
    rate_.resize(x.size());
    value_.resize(problem.guard_count());
    value_rate_.resize(problem.guard_count());
    problem.derivative(x, rate_);
    problem.guards(x, value_);
    problem.guard_rates(x, rate_, value_rate_);
  }

  bool is_of_branch(Index guard) const {
    const Index yield = phase_->contact->branch_guard;
    return yield >= 0 && (guard == yield || guard == yield + 1);
  }

  /// What ends a branch: the contact yields, if it comes so deep, or turns, where that is watched. A time
  /// that could not be computed is not a number, and must not pass for an event that never comes.
  std::optional<End> end_of_branch(const Problem& problem, const PairMotion& motion,
                                   const Indentation& begin) const {
    const Index yield = phase_->contact->branch_guard, turn = yield + 1;
    if (yield < 0) return std::nullopt;
    return std::visit(
        [&](const auto& one) -> std::optional<End> {
          // The guard of yield is δ less where that happens.
          if (problem.crossings()[yield] != Crossing::none) {
            const auto yields = one.reach(begin.value - value_[yield]);
            const bool is_noise = !(yields.there.rate > phase_->yield_speed);
            if (yields.time != infinity && !is_noise) return End{yields.time, yield, yields.there};
          }
          if (problem.crossings()[turn] != Crossing::falling) return std::nullopt;
          const auto [parting, there] = one.recede(phase_->contact->turn_speed);
          return End{parting, turn, there};
        },
        motion);
  }

  End opening(const PairMotion& motion) const {
    const auto [duration, last] = std::visit([](const auto& one) { return one.opening(); }, motion);
    return {duration, phase_->guard, last};
  }

  /// The contact lets go, yields or turns, unless another gap closes before.
  End first_event(const Problem& problem, const PairMotion& motion, const Indentation& begin) const {
    const PairPhase& phase = *phase_;
    const auto branch = end_of_branch(problem, motion, begin);
    End end = branch && branch->duration != infinity ? *branch : opening(motion);
    const auto last = end.last;
    const double longest = end.duration;
    for (Index i = 0; i < problem.guard_count(); ++i) {
      if (i == phase.guard || is_of_branch(i) || problem.crossings()[i] != Crossing::falling) continue;
      const auto gap = concave_gap(phase, i, value_[i], value_rate_[i], begin.rate);
      // Touching bodies at rest elsewhere keep a gap of exactly zero: that is no crossing.
      if (gap.value + gap.rate * longest + gap.coupling * (last.value - begin.value) >= 0) continue;
      const double time = std::max(0.0, std::visit([&](const auto& one) { return one.fall(gap); }, motion));
      if (time < end.duration) end = {time, i, last};
    }
    return end;
  }

  std::optional<PairPhase> phase_;
  std::vector<double> start_, rate_, value_, value_rate_;
  Simultaneous simultaneous_;
};

}  // namespace

std::unique_ptr<Flow> make_pair_flow() {
  return std::make_unique<Pair>();
}

}  // namespace mariotte::flow
