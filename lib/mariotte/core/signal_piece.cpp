#include "mariotte/core/signal_piece.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mariotte {

double value(const SignalPiece& p, double time) {
  const double s = time - p.start;
  const double sum = p.power[0] + s * (p.power[1] + s * (p.power[2] + s * p.power[3]));
  return p.amplitude == 0 ? sum : sum + p.amplitude * std::sin(p.frequency * time + p.phase);
}

SignalPiece rate(const SignalPiece& p) {
  return {.start = p.start,
          .amplitude = p.amplitude * p.frequency,
          .frequency = p.frequency,
          .phase = p.phase + std::numbers::pi / 2,
          .power = {p.power[1], 2 * p.power[2], 3 * p.power[3], 0}};
}

void expand(const SignalPiece& piece, double time, std::span<double> coefficients) {
  const double s = time - piece.start, angle = piece.frequency * time + piece.phase;
  const auto& c = piece.power;
  const double power[] = {c[0] + s * (c[1] + s * (c[2] + s * c[3])), c[1] + s * (2 * c[2] + 3 * s * c[3]),
                          c[2] + 3 * s * c[3], c[3]};
  std::fill(coefficients.begin(), coefficients.end(), 0.0);
  std::copy_n(power, std::min(std::size(power), coefficients.size()), coefficients.begin());
  if (piece.amplitude == 0) return;
  const double turn[] = {std::sin(angle), std::cos(angle), -std::sin(angle), -std::cos(angle)};
  double size = piece.amplitude;
  for (std::size_t k = 0; k < coefficients.size(); size *= piece.frequency / static_cast<double>(++k))
    coefficients[k] += size * turn[k % 4];
}

}  // namespace mariotte
