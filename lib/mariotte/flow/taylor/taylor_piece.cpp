#include "mariotte/flow/taylor/taylor_piece.hpp"

#include <algorithm>

#include "mariotte/flow/roots/polynomial.hpp"

namespace mariotte::flow::taylor {

std::span<const double> Piece::coefficients(Quantity quantity, int lane, Coefficients& c) const {
  series->coefficients(quantity, lane, c.data());
  return {c.data(), static_cast<std::size_t>(order) + 1};
}

double Piece::place(double time, double end_time) const {
  if (!series || clock == Expansion::plain) return time;
  if (!(time < end_time)) return end;  // the end of a step, less its start, may be longer by rounding
  Coefficients c;
  const auto t = coefficients(Quantity::time, clock, c);
  return rise_to(t, time, end);
}

void PieceStep::show(double place, State x) const {
  scratch_.resize(window_.lanes.count);
  piece_.evaluate(place, scratch_);
  write(window_, scratch_, x);
}

void PieceStep::at(double time, State x) const {
  show(piece_.place(time - start, duration_), x);
}

void PieceStep::inside(double fraction, State x) const {
  const bool is_time = !piece_.series || piece_.clock == Expansion::plain;
  show(fraction * (is_time ? duration_ : piece_.end), x);
}

/// Whether the series has the force of this contact.
bool PieceStep::acts(int lane) const {
  const auto& l = window_.lanes;
  if (!window_.pushes(lane) || !(l.active[lane] > 0)) return false;
  return piece_.start || lane == piece_.clock || l.indentation[lane] > 0 || !window_.is_sharp(lane);
}

bool PieceStep::series(PushSeries& push) const {
  static_assert(order_limit <= most_orders);
  if (window_.lanes.mixed || window_.lanes.widened || window_.lanes.segmented) return false;
  push.order = piece_.order;
  push.end = piece_.end;
  push.is_time = piece_.clock == Expansion::plain;
  push.has_roots = !window_.lanes.general;
  push.power = piece_.start ? piece_.start->power() : 0;
  push.contact.clear();
  push.dozing.clear();
  for (int lane = 0; lane < window_.lanes.count; ++lane)
    if (acts(lane))
      fill_force(lane, push.contact.emplace_back());
    else if (window_.pushes(lane) && piece_.series)
      fill_motion(lane, push.dozing.emplace_back());
  if (piece_.series)
    piece_.series->coefficients(Quantity::clock, std::max(piece_.clock, 0), push.pace.data());
  return true;
}

bool PieceStep::indentation(Index gap, IndentationSeries& motion) const {
  if (!piece_.series) return false;
  const auto& all = window_.contacts;
  const auto is_it = [&](const auto* contact) { return contact->gap == gap; };
  const auto last = all.begin() + static_cast<Index>(std::min(motion.found, all.size()));
  auto found = std::find_if(last, all.end(), is_it);
  if (found == all.end()) found = std::find_if(all.begin(), last, is_it);
  if (found == all.end() || !is_it(*found)) return false;
  motion.found = static_cast<std::size_t>(found - all.begin());
  const int lane = static_cast<int>(motion.found);
  piece_.series->coefficients(Quantity::indentation, lane, motion.depth.data());
  piece_.series->coefficients(Quantity::rate, lane, motion.rate.data());
  motion.depth[0] += (*found)->origin;
  motion.order = piece_.order;
  motion.end = piece_.end;
  return true;
}

void PieceStep::fill_force(int lane, PushSeries::Contact& c) const {
  fill_motion(lane, c);
  if (piece_.start)
    piece_.start->coefficients(lane, c.depth, c.root);
  else
    piece_.series->coefficients(Quantity::root, lane, c.root.data());
}

void PieceStep::fill_motion(int lane, PushSeries::Contact& c) const {
  c.gap = window_.contact(lane).gap;
  c.owns_clock = lane == piece_.clock;
  c.is_curved = window_.is_sharp(lane);
  if (!piece_.series) return;
  piece_.series->coefficients(Quantity::indentation, lane, c.depth.data());
  piece_.series->coefficients(Quantity::rate, lane, c.rate.data());
}

}  // namespace mariotte::flow::taylor
