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

/// Runs at speeds, and what they have told.
template <class Rebound>
class CaptureRuns {
 public:
  explicit CaptureRuns(Rebound& rebound_at) : rebound_at_(rebound_at) {}

  bool is_captured(double speed) {
    ++count;
    const ReboundSpeed last = rebound_at_(speed);
    blur = last.blur() / speed;
    if (last.speed != 0) ahead.add(speed, last.speed * last.speed);
    return last.speed == 0;
  }

  CaptureGuess ahead;
  double blur = 0;
  int count = 0;

 private:
  Rebound& rebound_at_;
};

/// From `guess` by factors of two; empty if all of them end alike.
template <class Rebound>
std::optional<CaptureVelocity> double_until_other(CaptureRuns<Rebound>& runs, double guess) {
  constexpr int most_doublings = 20;
  const bool start = runs.is_captured(guess);
  double near = guess;
  for (int i = 0; i < most_doublings; ++i) {
    const double next = start ? 2 * near : 0.5 * near;
    if (runs.is_captured(next) != start)
      return CaptureVelocity{.captured = start ? near : next, .separated = start ? next : near};
    near = next;
  }
  return std::nullopt;
}

/// From `guess`, then until the bracket is `tolerance` wide, relative to its speed. `rebound_at(speed)` is a
/// ReboundSpeed.
template <class Rebound>
std::optional<CaptureVelocity> bracket_capture(Rebound&& rebound_at, double guess, double tolerance) {
  CaptureRuns runs(rebound_at);
  auto found = double_until_other(runs, guess);
  if (!found) return found;
  while (found->separated - found->captured > std::max(tolerance * found->value(), runs.blur)) {
    const double speed = runs.ahead.next(*found, tolerance);
    if (speed <= found->captured || speed >= found->separated) break;  // neighbours as numbers
    (runs.is_captured(speed) ? found->captured : found->separated) = speed;
  }
  found->runs = runs.count;
  return found;
}

}  // namespace mariotte::impact
