#include "mariotte/flow/pair/pair.hpp"

#include <algorithm>

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
  void put(double time, const Indentation& now, State x) const {
    const double approach = origin_[phase_.left] - origin_[phase_.right];
    const double deepened = now.value + origin_[phase_.gap], lost = approach - now.rate;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = origin_[i] + time * free_rate(i, approach);
    x[phase_.left] = origin_[phase_.left] - phase_.left_share * lost;
    x[phase_.right] = origin_[phase_.right] + phase_.right_share * lost;
    x[phase_.gap] = 0 - now.value;  // never −0
    if (phase_.left_gap >= 0) x[phase_.left_gap] += phase_.left_share * deepened;
    if (phase_.right_gap >= 0) x[phase_.right_gap] += phase_.right_share * deepened;
    const double m = phase_.law.reduced_mass;
    if (phase_.work >= 0) x[phase_.work] = origin_[phase_.work] + 0.5 * m * lost * (approach + now.rate);
    if (phase_.impulse >= 0) x[phase_.impulse] = origin_[phase_.impulse] + m * lost;
  }

 private:
  /// Rate of a component as if the pair moved with its mass centre.
  double free_rate(std::size_t component, double approach) const {
    const auto i = static_cast<Index>(component);
    if (i == phase_.left || i == phase_.right || i == phase_.gap || i == phase_.work || i == phase_.impulse)
      return 0;
    if (i == phase_.left_gap) return rate_[component] - phase_.left_share * approach;
    if (i == phase_.right_gap) return rate_[component] - phase_.right_share * approach;
    return rate_[component];
  }

  const PairPhase& phase_;
  const PairMotion& motion_;
  ConstState origin_, rate_;
};

/// The gap that guard i watches, as the pair moves it.
ConcaveGap concave_gap(const PairPhase& phase, Index guard, double value, double rate, double approach) {
  const double share = guard == phase.left_guard    ? phase.left_share
                       : guard == phase.right_guard ? phase.right_share
                                                    : 0;
  return {value, rate - share * approach, share};
}

}  // namespace

bool Pair::admits(const Problem& problem) {
  const auto* phase = problem.serial();
  phase_ = phase ? find_pair(*phase) : std::nullopt;
  return phase_.has_value();
}

Arrival Pair::follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) {
  const PairPhase& phase = phase_.value();
  start_.assign(x.begin(), x.end());
  rate_.resize(x.size());
  value_.resize(problem.guard_count());
  value_rate_.resize(problem.guard_count());
  problem.derivative(x, rate_);
  problem.guards(x, value_);
  problem.guard_rates(x, rate_, value_rate_);

  const Indentation begin{-x[phase.gap], x[phase.left] - x[phase.right]};
  const auto motion = make_pair_motion(phase.law, begin);
  double duration = std::visit([](const auto& one) { return one.duration(); }, motion);
  const double turn = std::visit([](const auto& one) { return one.turn(); }, motion);
  const auto last = std::visit([&](const auto& one) { return one.at(duration); }, motion);
  const double opening = duration;
  Index guard = phase.guard;
  for (Index i = 0; i < problem.guard_count(); ++i) {
    if (i == phase.guard || problem.crossings()[i] != Crossing::falling) continue;
    const auto gap = concave_gap(phase, i, value_[i], value_rate_[i], begin.rate);
    // Touching bodies at rest elsewhere keep a gap of exactly zero: that is no crossing.
    if (gap.value + gap.rate * opening + gap.share * (last.value - begin.value) >= 0) continue;
    const double time = std::max(0.0, std::visit([&](const auto& one) { return one.fall(gap); }, motion));
    if (!(time < duration)) continue;
    duration = time;
    guard = i;
  }
  const bool limited = request.limit < duration;
  if (limited) duration = request.limit;

  PairStep step(phase, motion, start_, rate_);
  if (!limited && guard == phase.guard)
    step.put(duration, last, x);
  else
    step.at(duration, x);
  // Two steps that meet at the largest indentation put the peak where a watcher looks first.
  if (request.watcher) {
    step.before = start_;
    std::vector<double> deepest(x.size());
    if (turn > 0 && turn < duration) {
      step.at(step.end = turn, deepest);
      step.after = deepest;
      request.watcher->watch(step);
      step.before = deepest;
      step.start = turn;
    }
    step.end = duration;
    step.after = x;
    request.watcher->watch(step);
  }
  if (!limited) {
    fired.push_back(guard);
    simultaneous_.collect(problem, x, simultaneity_window(problem, request.accuracy), fired);
  }
  return {.outcome = limited ? Outcome::limit : Outcome::guard,
          .duration = duration,
          .steps = 1,
          .rhs = 1,
          .message = {}};
}

}  // namespace mariotte::flow
