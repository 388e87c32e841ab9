// Which guard ends a step, and where.
#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"

namespace mariotte::flow::taylor {

void Stepper::search(const Piece& piece, Quantity quantity, int lane, double side, double level, Index guard,
                     Fall& fall) const {
  Coefficients c;
  const auto used = piece.coefficients(quantity, lane, c);
  for (double& coefficient : c) coefficient *= side;
  c[0] += level;
  const auto place = flow::first_fall(used, std::min(piece.end, fall.place));
  if (place && *place < fall.place) fall = {guard, lane, *place};
}

/// Where a branch ends: the contact yields or turns.
void Stepper::search_branch(const Piece& piece, int lane, Fall& fall) const {
  const auto& l = window.lanes;
  const Index yields = window.contact(lane).branch_guard, turns = yields + 1;
  if (l.yield_side[lane] > 0)
    search(piece, Quantity::indentation, lane, -1, l.yield_level[lane], yields, fall);
  if (l.turn_side[lane] != 0)
    search(piece, Quantity::rate, lane, l.turn_side[lane], l.turn_level[lane], turns, fall);
}

/// End the piece where the root of an indentation passes zero. A contact that comes to δ = 0 and turns there
/// goes on as √δ = |t|, and its series as t: beyond, the contact would pull.
void Stepper::end_at_turn(Piece& piece, int lane) {
  const auto& l = window.lanes;
  if (lane == piece.clock || !(l.active[lane] > 0) || !window.is_sharp(lane)) return;
  Coefficients c;
  const auto place = flow::first_fall(piece.coefficients(Quantity::root, lane, c), piece.end);
  if (!place || !(*place < piece.end)) return;
  shorten(piece, *place);
  wake_gently(piece);
}

/// The first guard that fires where some margin leaves it open.
Fall Stepper::search_guards(Piece& piece) {
  Fall fall;
  const auto& l = window.lanes;
  for (int j = 0; j < l.count; ++j)
    if (l.side[j] > 0 && values_.margin[j] < 0) end_at_turn(piece, j);
  for (int j = 0; j < l.count; ++j) {
    const auto& c = window.contact(j);
    if (l.side[j] != 0 && !dozes(j) && (values_.margin[j] < 0 || has_faded(j)))
      search(piece, Quantity::indentation, j, l.side[j], l.level[j], c.guard, fall);
    if (l.load_side[j] != 0 && values_.load_margin[j] < 0)
      search(piece, Quantity::load, j, l.load_side[j], load_noise(window, j, precision_.tolerance),
             c.load_guard, fall);
    if (l.branched && values_.branch_margin[j] < 0) search_branch(piece, j, fall);
  }
  return fall;
}

Fall Stepper::first_fall(Piece& piece) {
  Fall fall;
  if (!piece.series) return fall;  // a start is chosen so short that none fires
  if (values_.may_fall) piece.series->sharpen(piece.end, values_);
  if (values_.may_fall || !window.lanes.has_leeway()) fall = search_guards(piece);
  if (piece.lands && fall.guard < 0) {  // one that comes down to δ = 0 may have lost its load, too
    const auto& c = window.contact(piece.clock);
    fall = {c.opens_loaded() ? c.guard : c.load_guard, piece.clock, piece.end};
  }
  if (fall.guard >= 0) end_at(fall, piece);
  if (fall.guard >= 0) stand_at(fall, piece);
  return fall;
}

/// The series of δ and of its clock have errors of their own, so δ need not be exactly where that ends.
void Stepper::stand_at(const Fall& fall, const Piece& piece) {
  const auto& c = window.contact(fall.lane);
  double& depth = values_.indentation[fall.lane];
  if (piece.lands && fall.lane == piece.clock) depth = 0;
  if (fall.guard == c.guard) depth = c.role == Role::open ? c.level : 0 - window.lanes.level[fall.lane];
  if (fall.guard == c.branch_guard) depth = window.lanes.yield_level[fall.lane];
}

bool Stepper::may_fall_soon(const Fall& fall, double time) const {
  const auto& l = window.lanes;
  if (window.drives || l.damped || l.branched || window.outside_time <= window.time + 2 * time) return true;
  for (int j = 0; j < l.count; ++j) {
    const double left = l.side[j] * l.indentation[j] + l.level[j];
    if (j != fall.lane && l.side[j] != 0 && left <= 2 * time * std::abs(l.rate[j])) return true;
  }
  return false;
}

/// Behind its fall a neighbour would pull, and hide that a contact has been late before.
void Stepper::end_at(Fall& fall, Piece& piece) {
  shorten(piece, fall.place);
  wake_gently(piece);
  if (piece.end < fall.place) fall = {};
}

}  // namespace mariotte::flow::taylor
