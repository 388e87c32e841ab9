// Slopes of a contact that pushes alone, in closed form.
#pragma once
#include <utility>

#include "mariotte/contact/power_law.hpp"

namespace mariotte::impact {

/// A contact that pushes alone through a step: δ̈ = −κ δⁿ.
struct AloneStep {
  double exponent, kappa, duration;
  double depth, rate, last_depth, last_rate;

  double bend(double at) const { return -kappa * at * contact::contact_width(exponent, at); }
  double energy() const { return 0.5 * (exponent + 1) * rate * rate - bend(depth) * depth; }

  /// Slopes of depth and rate at the end by those at the start and `stretch` κ_p/(2κ):
  /// S_δ = a δ̇ + b (δ + (n−1)/2 t δ̇) + κ_p t δ̇/(2κ).
  std::pair<double, double> slopes(double by_depth, double by_rate, double stretch) const {
    const double more = 0.5 * (exponent + 1), less = 0.5 * (exponent - 1), last_bend = bend(last_depth);
    const double other = by_rate - rate * stretch;
    const double a = (more * rate * by_depth - depth * other) / energy();
    const double b = (rate * other - bend(depth) * by_depth) / energy();
    return {a * last_rate + b * (last_depth + less * duration * last_rate) + duration * last_rate * stretch,
            a * last_bend + b * (more * last_rate + less * duration * last_bend) +
                (last_rate + duration * last_bend) * stretch};
  }
};

}  // namespace mariotte::impact
