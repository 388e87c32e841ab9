#include "mariotte/flow/taylor/taylor_piece.hpp"

#include "mariotte/core/bracket.hpp"
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
  return locate_sign_change([&](double at) { return horner(t, at) - time; }, 0, -time, end, end_time - time,
                            epsilon * end);
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

}  // namespace mariotte::flow::taylor
