// Slopes of scenes that are written in a test.
#pragma once
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/stencil.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"

namespace mariotte::test {

inline constexpr const char* triplet = R"([chain]
radius = ["10 mm", "12 mm", "9 mm"]
material = { young = "210 GPa", poisson = 0.3, density = "7800 kg/m^3" }
law = "hertz"
velocity = ["1 m/s", 0, 0]
gap = "1 um"
)";

inline impact::Sensitivity slopes_of(const std::string& text, const std::vector<std::string>& keys = {}) {
  const auto document = scene::parse_document(text, "test");
  return study::sensitivity(document, resolve(document), keys);
}

inline double slope(const impact::Sensitivity& slopes, const std::string& outcome, std::size_t parameter) {
  for (const auto& one : slopes.outcome)
    if (impact::name_of(one) == outcome) return one.slope.at(parameter).value();
  throw std::runtime_error("no outcome " + outcome);
}

/// How far a slope, times its number, is from differences of order eight of runs at 10⁻¹².
inline double deviation(const std::string& text, const std::string& outcome, const std::string& key) {
  const auto found = slopes_of(text, {key});
  const double value = found.parameter.front().value;
  double expected = 0;
  for (const auto& point : impact::stencil) {
    const auto moved = key + "=" + report::exact(value * (1 + 1e-3 * point.offset));
    const auto document = scene::parse_document(text, "test", {moved, "run.accuracy=1e-12"});
    for (const auto& one : study::outcomes(resolve(document)).outcome)
      if (impact::name_of(one) == outcome) expected += point.weight * one.value.value() / 1e-3;
  }
  return std::abs(slope(found, outcome, 0) * value - expected);
}

}  // namespace mariotte::test
