// Bracketing the speed that parts capture from separation, whatever strikes.
//
// Above it the speed of the rebound is ~ √(v − v_c), so its square is nearly straight: two of them tell where
// it vanishes. Runs on both sides of that close the bracket; where they do not, it is halved. It is closed no
// further than runs can tell the two apart.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "mariotte/impact/microbody/capture_velocity.hpp"

namespace mariotte::impact {

/// Of a run; `speed` is 0 where captured.
struct ReboundSpeed {
  double speed = 0;
  double error = 0;  ///< as the run says

  /// How much the square of the rebound may be off.
  double blur() const { return error * (2 * speed + error); }
};

/// The next speed to look at, by the two lowest that have separated.
class CaptureGuess {
 public:
  void add(double speed, double square) {
    last_ = first_;
    first_ = {speed, square};
  }
  /// Above and below where the square vanishes, by turns and by as much as that has moved; else the middle.
  double next(const CaptureVelocity& bracket, double tolerance) {
    const double middle = bracket.value(), width = bracket.separated - bracket.captured;
    idle_ = width > 0.5 * width_ ? idle_ + 1 : 0;
    width_ = width;
    if (idle_ > 1 || !(last_.square > first_.square)) {
      idle_ = 0;
      return middle;
    }
    const double slope = (last_.square - first_.square) / (last_.speed - first_.speed);
    const double root = first_.speed - first_.square / slope;
    const double margin = std::max(0.3 * tolerance * middle, std::abs(root - root_));
    root_ = root;
    above_ = !above_;
    const double aim = above_ ? root + margin : root - margin;
    return aim > bracket.captured && aim < bracket.separated ? aim : middle;
  }

 private:
  struct Rebound {
    double speed = 0, square = 0;
  };
  Rebound first_, last_;  ///< the lowest that has separated, and that before it
  double root_ = 0, width_ = infinity;
  int idle_ = 0;  ///< runs that have not halved the bracket
  bool above_ = false;
};

/// From `guess` by factors of two, then until the bracket is `tolerance` wide, relative to its speed.
/// `rebound_at(speed)` is a ReboundSpeed.
template <class Rebound>
std::optional<CaptureVelocity> bracket_capture(Rebound&& rebound_at, double guess, double tolerance) {
  constexpr int most_doublings = 20;
  CaptureVelocity found;
  CaptureGuess ahead;
  double rebound = 0, blur = 0;
  const auto is_captured = [&](double speed) {
    ++found.runs;
    const ReboundSpeed last = rebound_at(speed);
    rebound = last.speed;
    blur = last.blur() / speed;
    return rebound == 0;
  };
  const bool start = is_captured(guess);
  if (!start) ahead.add(guess, rebound * rebound);
  double near = guess, far = guess;
  for (int i = 0; far == near; ++i) {
    if (i == most_doublings) return std::nullopt;
    const double next = start ? 2 * near : 0.5 * near;
    if (is_captured(next) == start)
      near = far = next;
    else
      far = next;
    if (rebound != 0) ahead.add(next, rebound * rebound);
  }
  found.captured = start ? near : far;
  found.separated = start ? far : near;
  while (found.separated - found.captured > std::max(tolerance * found.value(), blur)) {
    const double speed = ahead.next(found, tolerance);
    if (speed <= found.captured || speed >= found.separated) break;  // the two are neighbours as numbers
    (is_captured(speed) ? found.captured : found.separated) = speed;
    if (rebound != 0) ahead.add(speed, rebound * rebound);
  }
  return found;
}

}  // namespace mariotte::impact
