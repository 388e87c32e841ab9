#include "mariotte/impact/sensitivity/late_damping.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/core/damping.hpp"

namespace mariotte::impact {
namespace {

/// Measured by differences of runs for q from 0.001 to 0.25: slopes are off by up to 3 · 10^{−28 q}.
constexpr double factor = 4, unresolved_depth = 1e-28;

template <class Power>
double lost(const std::optional<Power>& power) {
  if (!power || !(power->damping > 0) || power->exponent == 1) return 0;
  return factor * std::pow(unresolved_depth, damping_exponent(power->grows, power->exponent));
}

}  // namespace

double lost_at_contact(const contact::Law& law) {
  if (const auto* branched = contact::branched(law)) return lost(branched->power({}));
  return lost(contact::powers(law));
}

void note_late_damping(std::span<const contact::Law> laws, double accuracy, Sensitivity& slopes) {
  double error = 0;
  for (const auto& law : laws)
    if (contact::pulls(law)) error = std::max(error, lost_at_contact(law));
  if (!(error > accuracy)) return;
  char text[160];
  std::snprintf(
      text, sizeof text,
      "a damper pulls until depths that are not resolved, so slopes may be off by %.1g of their size", error);
  slopes.notes.push_back({.text = text, .error = error});
}

}  // namespace mariotte::impact
