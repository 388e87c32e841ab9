// A smooth function of time, of which signals are made.
#pragma once
#include <array>
#include <span>

namespace mariotte {

/// a sin(ω t + φ) + c₀ + c₁ s + c₂ s² + c₃ s³ with s = t − start.
struct SignalPiece {
  double start = 0;                  ///< from this time on [s]
  double amplitude = 0;              ///< a, in the unit of the signal
  double frequency = 0;              ///< ω ≥ 0 [rad/s]
  double phase = 0;                  ///< φ [rad]
  std::array<double, 4> power = {};  ///< c₀ to c₃
};

/// At any time: a piece goes on smoothly beyond its ends.
double value(const SignalPiece& piece, double time);
/// The derivative.
SignalPiece rate(const SignalPiece& piece);
/// Coefficients 0, 1, … of the power series around a time.
void expand(const SignalPiece& piece, double time, std::span<double> coefficients);

}  // namespace mariotte
