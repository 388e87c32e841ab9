#include "differences.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mariotte/impact/sensitivity/stencil.hpp"

namespace mariotte::stress_study {
namespace {

constexpr int lengths = 8;
constexpr double shortening = 0.25;
/// Of what outcomes are, or are compared with: rounding of the best runs.
constexpr double noise = 1e-14;

using Values = std::vector<double>;

std::optional<Values> values_at(const Probe& probe, double value, const impact::Sensitivity& base) {
  const auto moved = probe.outcomes(value);
  if (moved.ending != base.ending || moved.outcome.size() != base.outcome.size()) return std::nullopt;
  Values values;
  for (const auto& outcome : moved.outcome) values.push_back(outcome.value.value_or(0));
  return values;
}

std::optional<Values> difference(const Probe& probe, double step, const impact::Sensitivity& base,
                                 const Values& sizes) {
  Values sum(sizes.size(), 0.0);
  for (const auto& point : impact::stencil) {
    const auto values = values_at(probe, probe.value + point.offset * step, base);
    if (!values) return std::nullopt;
    for (std::size_t i = 0; i < sum.size(); ++i)
      if (sizes[i] > 0) sum[i] += point.weight * ((*values)[i] / sizes[i]) * (probe.unit / step);
  }
  return sum;
}

}  // namespace

Values outcome_sizes(const impact::Sensitivity& slopes, double speed) {
  double impulse = 0, spin = 0;
  for (const auto& one : slopes.outcome) {
    if (one.name == "impulse") impulse = std::max(impulse, std::abs(*one.value));
    if (one.unit == "rad/s") spin = std::max(spin, std::abs(*one.value));
  }
  Values sizes;
  for (const auto& one : slopes.outcome)
    sizes.push_back(one.unit == "m/s"     ? speed
                    : one.unit == "N s"   ? impulse
                    : one.unit == "s"     ? std::abs(one.value.value_or(0))
                    : one.unit == "rad/s" ? spin
                                          : 0);
  return sizes;
}

Differences differences(const Probe& probe, const impact::Sensitivity& base, const Values& sizes,
                        double steepness) {
  Differences best;
  std::optional<Values> before;
  double step = std::min(probe.step, 0.1 * probe.unit / steepness);
  for (int k = 0; k < lengths; ++k, step *= shortening) {
    const auto now = difference(probe, step, base, sizes);
    if (now && before)
      for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (best.slope.empty()) best = {Values(sizes.size(), 0.0), Values(sizes.size(), infinity)};
        const double value = std::max(1.0, std::abs(base.outcome[i].value.value_or(0) / sizes[i]));
        const double rounding = noise * value * probe.unit / step;
        const double doubt = std::max(std::abs((*now)[i] - (*before)[i]), rounding);
        if (doubt < best.doubt[i]) best.slope[i] = (*now)[i], best.doubt[i] = doubt;
      }
    before = now;
  }
  return best;
}

}  // namespace mariotte::stress_study
