// Functions of time that are smooth but for kinks: what a drive prescribes.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "mariotte/core/signal_piece.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::model {

/// Pieces in order of time, at least one. The first starts at 0; the last goes on for ever.
struct Signal {
  std::vector<SignalPiece> piece;
};

/// A value at a time.
struct SignalPoint {
  double time;  ///< [s]
  double value;
};

/// The first point whose time does not grow from that of the one before, or from 0, or that is not finite.
std::optional<std::size_t> first_fall(const std::vector<SignalPoint>& points);
inline constexpr std::string_view rule_of_signal =
    "times of a signal must begin at 0 and grow, and all numbers be finite";

/// a sin(ω t + φ).
Signal sine(double amplitude, double frequency, double phase);
/// a sin(π t/T) for t < T, 0 from then on. Throws InvalidParameter unless T > 0.
Signal half_sine(double amplitude, double duration);
/// Straight lines through points; the last value stays. Throws InvalidParameter
/// unless there are two points, times grow from 0, and all is finite.
Signal straight_lines(const std::vector<SignalPoint>& points);
/// The monotone cubic through points; else the same.
Signal smooth_curve(const std::vector<SignalPoint>& points);

using mariotte::rate;
/// The derivative of all pieces.
Signal rate(const Signal& signal);
/// The piece that holds at a time.
Index piece_at(const Signal& signal, double time);
/// ∫ of the signal from 0 to a time.
double integral(const Signal& signal, double time);
/// About the largest size of the signal until a time, or until its last kink where that is infinite.
double largest(const Signal& signal, double until);
/// The same of its integral from 0.
double largest_integral(const Signal& signal, double until);
/// The same function in other units of time and value.
Signal scaled(Signal signal, double time, double value);

}  // namespace mariotte::model
