// Bracketing the speed that parts capture from separation, whatever strikes.
#pragma once
#include <optional>

#include "mariotte/impact/microbody/capture_velocity.hpp"

namespace mariotte::impact {

/// From `guess` by factors of two, then halved until the bracket is `tolerance` wide, relative to its speed.
template <class IsCaptured>
std::optional<CaptureVelocity> bracket_capture(IsCaptured&& is_captured_at, double guess, double tolerance) {
  constexpr int most_doublings = 20;
  CaptureVelocity found;
  const auto is_captured = [&](double speed) {
    ++found.runs;
    return is_captured_at(speed);
  };
  const bool start = is_captured(guess);
  double near = guess, far = guess;
  for (int i = 0; far == near; ++i) {
    if (i == most_doublings) return std::nullopt;
    const double next = start ? 2 * near : 0.5 * near;
    if (is_captured(next) == start)
      near = far = next;
    else
      far = next;
  }
  found.captured = start ? near : far;
  found.separated = start ? far : near;
  while (found.separated - found.captured > tolerance * found.value()) {
    const double middle = found.value();
    if (middle <= found.captured || middle >= found.separated) break;  // the two are neighbours as numbers
    (is_captured(middle) ? found.captured : found.separated) = middle;
  }
  return found;
}

}  // namespace mariotte::impact
