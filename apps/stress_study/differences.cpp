#include "differences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "judge.hpp"

namespace mariotte::stress_study {
namespace {

constexpr int lengths = 10;
constexpr double shortening = 0.25;
constexpr double clearly = 2;   ///< times the doubts of two estimates: they contradict each other
constexpr double hair = 1e-12;  ///< of the unit of a number: what it moves is next to rounding
/// Of what outcomes are, or are compared with: least rounding of the best runs.
constexpr double least_noise = 1e-14;

using Values = std::vector<double>;

constexpr int reach = 4;
/// The slope in the middle of values at −4 … 4 steps: of order eight from both sides, three from one.
using Formula = std::array<double, 2 * reach + 1>;
constexpr Formula both_sides = {1.0 / 280, -4.0 / 105, 0.2, -0.8, 0, 0.8, -0.2, 4.0 / 105, -1.0 / 280};
constexpr Formula left_side = {-11.0 / 6, 7, -9.5, 13.0 / 3, 0, 0, 0, 0, 0};
constexpr Formula right_side = {0, 0, 0, 0, 0, -13.0 / 3, 9.5, -7, 11.0 / 6};

double magnified(const Formula& formula) {
  double sum = 0;
  for (const double weight : formula) sum += std::abs(weight);
  return sum;
}

/// Points must be numbers that exist, or their distances are not what they are divided by.
double representable(const Probe& probe, double step) {
  const double last = std::abs(probe.value) + reach * step;
  const double grain = std::nextafter(last, infinity) - last;
  return grain * std::round(step / grain);
}

/// Outcomes next to a number; empty where the run is another.
class Neighbours {
 public:
  Neighbours(const Probe& probe, double step, const impact::Sensitivity& base) : step_(step) {
    for (int k = -reach; k <= reach; ++k)
      if (k != 0) read(probe.outcomes(probe.value + k * step), base, values_[k + reach]);
  }
  double step() const { return step_; }
  /// By how much each outcome differs from the base at most, over its size; infinite where the run is
  /// another.
  Values spread(const impact::Sensitivity& base, const Values& sizes) const {
    Values most(sizes.size(), 0.0);
    for (std::size_t k = 0; k < values_.size(); ++k)
      for (std::size_t i = 0; i < most.size(); ++i) {
        if (k == reach || !(sizes[i] > 0)) continue;
        if (values_[k].empty()) return Values(sizes.size(), infinity);
        const double apart = std::abs(values_[k][i] - base.outcome[i].value.value_or(0));
        most[i] = std::max(most[i], apart / sizes[i]);
      }
    return most;
  }
  /// By how much each outcome is off the middle of those on both sides at most, over its size.
  Values bend(const impact::Sensitivity& base, const Values& sizes) const {
    Values most(sizes.size(), 0.0);
    for (int k = 1; k <= reach; ++k)
      for (std::size_t i = 0; i < most.size(); ++i) {
        if (!(sizes[i] > 0)) continue;
        const auto &before = values_[reach - k], &after = values_[reach + k];
        if (before.empty() || after.empty()) return Values(sizes.size(), infinity);
        const double middle = 0.5 * (before[i] + after[i]);
        most[i] = std::max(most[i], std::abs(middle - base.outcome[i].value.value_or(0)) / sizes[i]);
      }
    return most;
  }
  /// Per unit of outcomes and of the number.
  Values slope(const Formula& formula, const Values& sizes, double unit) const {
    Values sum(sizes.size(), 0.0);
    for (std::size_t k = 0; k < formula.size(); ++k) {
      if (formula[k] == 0) continue;
      if (values_[k].empty()) return {};
      for (std::size_t i = 0; i < sum.size(); ++i)
        if (sizes[i] > 0) sum[i] += formula[k] * (values_[k][i] / sizes[i]) * (unit / step_);
    }
    return sum;
  }

 private:
  static void read(const impact::Sensitivity& moved, const impact::Sensitivity& base, Values& values) {
    if (moved.ending != base.ending || moved.outcome.size() != base.outcome.size()) return;
    for (const auto& outcome : moved.outcome) values.push_back(outcome.value.value_or(0));
  }

  double step_;
  std::array<Values, 2 * reach + 1> values_;
};

/// Moves what is next to rounding, but no number across zero: a gap may not be negative.
double hair_of(const Probe& probe) {
  const double most = hair * probe.unit, own = std::abs(probe.value) / (2 * reach);
  return representable(probe, own > 0 ? std::min(most, own) : most);
}

/// What rounding makes of each outcome, over its size: runs whose number differs by rounding tell it, and
/// those a little further away what jumps there are between them.
Values noise(const Probe& probe, const impact::Sensitivity& base, const Values& sizes) {
  const double step = representable(probe, 16 * epsilon * std::max(std::abs(probe.value), probe.unit));
  auto list = Neighbours(probe, step, base).spread(base, sizes);
  const auto jumps = Neighbours(probe, hair_of(probe), base).bend(base, sizes);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (sizes[i] > 0)
      list[i] +=
          jumps[i] + least_noise * std::max(1.0, std::abs(base.outcome[i].value.value_or(0) / sizes[i]));
  return list;
}

/// One formula with ever shorter steps.
class Shrinking {
 public:
  Shrinking(const Formula& formula, const Probe& probe, const Values& sizes, const Values& noise)
      : formula_(formula), probe_(probe), sizes_(sizes), noise_(noise) {}

  void add(const Neighbours& near) {
    const auto next = near.slope(formula_, sizes_, probe_.unit);
    if (!next.empty() && !now_.empty() && !before_.empty())
      for (std::size_t i = 0; i < sizes_.size(); ++i) compare(i, next[i]);
    before_ = std::exchange(now_, next);
    step_ = near.step();
  }
  const Estimate& best() const { return best_; }

 private:
  /// Runs round their outcomes, and the number itself.
  double rounding(std::size_t i, double slope, double step) const {
    return (noise_[i] * magnified(formula_) / 2 * probe_.unit + epsilon * std::abs(probe_.value * slope)) /
           step;
  }
  /// Two that agree may do so by chance; what is left of a shorter step is noise, which steps divide. What
  /// shorter steps contradict belongs to another order of events.
  void compare(std::size_t i, double next) {
    if (best_.slope.empty()) best_ = {Values(sizes_.size(), 0.0), Values(sizes_.size(), infinity)};
    const double doubt = std::max(
        {std::abs(now_[i] - before_[i]), shortening * std::abs(next - now_[i]), rounding(i, now_[i], step_)});
    const bool contradicts = std::abs(now_[i] - best_.slope[i]) > clearly * (doubt + best_.doubt[i]);
    if (doubt < best_.doubt[i] || contradicts) best_.slope[i] = now_[i], best_.doubt[i] = doubt;
  }

  const Formula& formula_;
  const Probe& probe_;
  const Values& sizes_;
  const Values& noise_;
  Values before_, now_;  ///< with the last two steps
  double step_ = 0;      ///< the last one
  Estimate best_;
};

}  // namespace

Values outcome_sizes(const impact::Sensitivity& slopes, const SlopeSubject& subject) {
  double impulse = subject.impulse, spin = subject.spin;
  for (const auto& one : slopes.outcome) {
    if (one.unit == "N s") impulse = std::max(impulse, std::abs(*one.value));
    if (one.unit == "rad/s") spin = std::max(spin, std::abs(*one.value));
  }
  Values sizes;
  for (const auto& one : slopes.outcome)
    sizes.push_back(one.unit == "m/s"     ? subject.speed
                    : one.unit == "N s"   ? impulse
                    : one.unit == "s"     ? std::abs(one.value.value_or(0))
                    : one.unit == "rad/s" ? spin
                                          : 0);
  return sizes;
}

std::vector<const Estimate*> Differences::of(std::size_t i) const {
  if (both.slope.empty()) return {};
  if (std::abs(left.slope[i] - right.slope[i]) > tolerated * (left.doubt[i] + right.doubt[i]))
    return {&left, &right};
  return {&both};
}

Differences differences(const Probe& probe, const impact::Sensitivity& base, const Values& sizes,
                        double steepness) {
  const auto rounding = noise(probe, base, sizes);
  Shrinking both(both_sides, probe, sizes, rounding), left(left_side, probe, sizes, rounding),
      right(right_side, probe, sizes, rounding);
  double step = std::min(probe.step, 0.1 * probe.unit / steepness);
  for (int k = 0; k < lengths; ++k, step *= shortening) {
    const double exact = representable(probe, step);
    if (exact == 0) break;
    const Neighbours near(probe, exact, base);
    for (auto* one : {&both, &left, &right}) one->add(near);
  }
  return {both.best(), left.best(), right.best()};
}

}  // namespace mariotte::stress_study
