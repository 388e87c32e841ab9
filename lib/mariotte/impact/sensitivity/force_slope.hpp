// How the force of a contact moves with the numbers of its law and with what it remembers, at a fixed state.
#pragma once
#include "mariotte/contact/contact_set.hpp"
#include "mariotte/contact/memory.hpp"
#include "mariotte/impact/sensitivity/contact_slope.hpp"

namespace mariotte::impact {

/// ∂f/∂p at fixed δ, δ̇ and memory, for a law that is `shifted`. With the indentation at which a contact lets
/// go its force moves as a whole, and may have a root there; so points keep their distance from it.
double law_force_slope(contact::ContactMode mode, const contact::Law& law, const LawSlope& slope,
                       double indentation, double rate, const contact::Memory& past);
/// ∂f/∂δ*, the slope by what the contact remembers.
double memory_force_slope(contact::ContactMode mode, const contact::Law& law, double indentation, double rate,
                          const contact::Memory& past);
/// Slopes of `value(law, past)` by parameter and by memory.
template <class Value>
double by_law(const LawSlope& slope, Value&& value) {
  if (slope.shifted.empty()) return 0;
  return stencil_slope(slope.points, slope.step, [&](std::size_t k) { return value(slope.shifted[k]); });
}
/// A step by which the peak that a contact remembers may move.
double memory_step(const contact::Memory& past);
template <class Value>
double by_memory(const contact::Memory& past, Value&& value) {
  const double step = memory_step(past);
  return stencil_slope(step, [&](std::size_t k) {
    auto moved = past;
    moved.peak += stencil[k].offset * step;
    return value(moved);
  });
}

}  // namespace mariotte::impact
