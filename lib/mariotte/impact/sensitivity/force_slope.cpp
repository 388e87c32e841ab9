#include "mariotte/impact/sensitivity/force_slope.hpp"

#include <cmath>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/model/contacts/contact_automaton.hpp"

namespace mariotte::impact {

using contact::Law;
using contact::Memory;
using model::force_in;

namespace {

/// dk δⁿ + dc δⁿ⁻¹ δ̇ + dn ln δ · f: the force of a power law as its numbers change.
double power_force_slope(const contact::PowerLaw& law, const contact::PowerLaw& slope, double indentation,
                         double rate) {
  if (!(indentation > 0)) return law.exponent > 1 ? 0 : slope.stiffness * indentation + slope.damping * rate;
  const double width = contact::contact_width(law.exponent, indentation);
  const double by_numbers = slope.stiffness * indentation + slope.damping * rate;
  if (slope.exponent == 0) return width * by_numbers;
  const double load = law.stiffness * indentation + law.damping * rate;
  return width * (by_numbers + slope.exponent * std::log(indentation) * load);
}

/// Where the force of a contact has its root.
double end_of(const Law& law, const Memory& past) {
  const auto* branches = branched(law);
  return branches ? branches->opening_indentation(past) : 0;
}

}  // namespace

double law_force_slope(contact::ContactMode mode, const Law& law, const LawSlope& slope, double indentation,
                       double rate, const Memory& past) {
  if (const auto* power = power_law(law)) {
    const bool touches = mode == contact::ContactMode::touching;
    const bool is_idle = touches && !(contact::load(law, std::max(0.0, indentation), rate).value > 0);
    return is_idle ? 0 : power_force_slope(*power, slope.power, indentation, rate);
  }
  const double end = end_of(law, past);
  const double force = by_law(slope, [&](const Law& moved) {
    return force_in(mode, moved, indentation + (end_of(moved, past) - end), rate, past).value;
  });
  const double shift = by_law(slope, [&](const Law& moved) { return end_of(moved, past) - end; });
  return force - force_in(mode, law, indentation, rate, past).by_indentation * shift;
}

double memory_step(const Memory& past) {
  return 0.01 * past.peak;
}

double memory_force_slope(contact::ContactMode mode, const Law& law, double indentation, double rate,
                          const Memory& past) {
  const double end = end_of(law, past);
  const double force = by_memory(past, [&](const Memory& moved) {
    return force_in(mode, law, indentation + (end_of(law, moved) - end), rate, moved).value;
  });
  const double shift = by_memory(past, [&](const Memory& moved) { return end_of(law, moved) - end; });
  return force - force_in(mode, law, indentation, rate, past).by_indentation * shift;
}

}  // namespace mariotte::impact
