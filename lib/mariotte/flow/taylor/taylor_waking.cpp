// Which contacts a step leaves out, and when they are heard again.
#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/roots/rough_root.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"
#include "mariotte/flow/taylor/window_parts.hpp"

namespace mariotte::flow::taylor {
namespace {

/// Between the depth from which a contact acts, 0, and that at which it is late, 1: where a step ends that
/// would go further, and what is a fault.
constexpr double in_time = 0.5, far_too_late = 2.25;

double depth_at(const Lanes& l, int lane, double place) {
  return l.acts_above[lane] + place * (l.late_above[lane] - l.acts_above[lane]);
}

}  // namespace

/// What touches and is left out is watched for the depth at which it would be late.
void Stepper::doze(int lane) {
  auto& l = window.lanes;
  if (window.contact(lane).role != Role::touching || !window.is_sharp(lane)) return;
  l.side[lane] = l.active[lane] > 0 ? 0 : -1;
  l.level[lane] = l.late_above[lane];
}

/// A slack contact whose load has a power of δ is watched for it only where its own force would be heard.
void Stepper::listen(int lane) {
  auto& l = window.lanes;
  if (window.contact(lane).role != Role::slack || !(l.steepening[lane] > 0)) return;
  l.load_side[lane] = l.indentation[lane] > wake_depth(window.contact(lane), window.speed) ? -1 : 0;
}

/// In a row the others only press a contact whose own force is left out, so that it is deepest at an end of a
/// piece, unless a drive draws it apart. Other links may draw it, too.
bool Stepper::cannot_be_late(const Piece& piece, int lane) const {
  if (values_.indentation[lane] > window.lanes.late_above[lane]) return false;
  if (!window.is_linked()) return !(window.lanes.drive[lane] < 0);
  return piece.start || (dozes(lane) && values_.margin[lane] >= 0);
}

/// End the piece where a contact whose force is left out has reached the depth at which it wakes. Where a
/// piece goes on beyond the end of a neighbour, that pulls, and hides at the end of the piece who was late:
/// so all are asked again at each new end.
void Stepper::wake_gently(Piece& piece) {
  if (!values_.is_deep && !window.may_draw()) return;
  const auto& l = window.lanes;
  const double end = piece.end;
  for (int j = 0; j < l.count; ++j) {
    if (l.active[j] > 0 || !window.pushes(j)) continue;
    if (cannot_be_late(piece, j)) continue;
    if (piece.start) {
      wake_in_start(piece, j);
    } else if (const auto place = waking(piece, j)) {
      shorten(piece, *place);
    }
  }
  if (piece.end < end) wake_gently(piece);
}

/// If the indentation gets late, the place at which it has not yet done so.
std::optional<double> Stepper::waking(const Piece& piece, int lane) const {
  Coefficients c;
  const auto used = piece.coefficients(Quantity::indentation, lane, c);
  for (double& coefficient : c) coefficient = -coefficient;
  const double depth = window.lanes.late_above[lane], start = c[0];
  c[0] = start + depth;
  if (values_.indentation[lane] <= depth && !flow::first_fall(used, piece.end)) return std::nullopt;
  c[0] = start + depth_at(window.lanes, lane, in_time);
  return flow::first_fall(used, piece.end);
}

bool Stepper::is_late() const {
  const auto& l = window.lanes;
  bool any = false;
  for (int j = 0; values_.is_deep && j < l.count; ++j)
    any |= !(l.active[j] > 0) && values_.indentation[j] > depth_at(l, j, far_too_late);
  return any;
}

/// In a start series what is left out only sinks deeper. Depths grow with some power of time.
void Stepper::wake_in_start(Piece& piece, int lane) {
  const double depth = std::max(window.lanes.indentation[lane], 0.0),
               goal = depth_at(window.lanes, lane, in_time);
  for (int tries = 0; tries < 60 && values_.indentation[lane] > window.lanes.late_above[lane]; ++tries) {
    const double secant = depth > 0 ? (goal - depth) / (values_.indentation[lane] - depth) : 0;
    const double power = rough_root(goal / values_.indentation[lane], 4);
    shorten(piece, piece.end * std::clamp(std::max(secant, power), 0.1, 0.98));
  }
}

}  // namespace mariotte::flow::taylor
