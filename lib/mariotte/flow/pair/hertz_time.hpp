// How long a Hertz contact takes: T(y) = ∫₀^y (1−u²)^{−3/5} du.
#pragma once
#include <array>
#include <cstddef>
#include <numbers>

namespace mariotte::flow {

/// Gauss's hypergeometric function ₂F₁(a, b; c; s) for 0 ≤ s ≤ 1/2 to rounding: its Taylor polynomial about s
/// = 1/4, whose terms fall like 3^{−k}.
class HalfHypergeometric {
 public:
  constexpr HalfHypergeometric(double a, double b, double c) {
    // Value and slope at the centre by the power series about 0, whose terms fall like 4^{−k}.
    long double term = 1, value = 0, slope = 0;
    for (int k = 0; k < 60; ++k) {
      value += term;
      slope += k * term / centre;
      term *= (a + k) * (b + k) / ((c + k) * (1 + k)) * centre;
    }
    // s(1−s) f'' + (c − (a+b+1) s) f' − a b f = 0, coefficient by coefficient in u = s − centre.
    const long double stretch = centre * (1 - centre), tilt = 1 - 2 * centre, sum = a + b + 1;
    std::array<long double, terms> f{value, slope};
    for (std::size_t k = 0; k + 2 < terms; ++k) {
      const auto n = static_cast<long double>(k);
      f[k + 2] =
          ((n * (n - 1) + sum * n + a * b) * f[k] - (n + 1) * (tilt * n + c - sum * centre) * f[k + 1]) /
          (stretch * (n + 2) * (n + 1));
    }
    for (std::size_t k = 0; k < terms; ++k) coefficient_[k] = static_cast<double>(f[k]);
  }

  /// Even and odd powers apart, so that two chains of products run side by side. V is a double or a register.
  template <class V>
  constexpr V operator()(V s) const {
    const V u = s - centre, square = u * u;
    V even = coefficient_[terms - 2] + V{}, odd = coefficient_[terms - 1] + V{};
    for (std::size_t k = terms - 2; k >= 2; k -= 2) {
      even = even * square + coefficient_[k - 2];
      odd = odd * square + coefficient_[k - 1];
    }
    return even + u * odd;
  }

 private:
  static constexpr double centre = 0.25;
  static constexpr std::size_t terms = 34;
  std::array<double, terms> coefficient_{};
};

/// T(y) = y ₂F₁(1/2, 3/5; 3/2; y²), and T(1) − T(y) = (5/4) z^{2/5} ₂F₁(2/5, 1/2; 7/5; z) with z = 1 − y²;
/// each up to y² = z = 1/2.
inline constexpr HalfHypergeometric from_middle(0.5, 0.6, 1.5), from_end(0.4, 0.5, 1.4);
inline constexpr double hertz_middle = 0.5 * std::numbers::sqrt2;  ///< y where the two forms meet
inline constexpr double hertz_half_depth = 0.75785828325519904;    ///< z^{2/5} there
inline constexpr double full_hertz_time =                          ///< T(1)
    hertz_middle * from_middle(0.5) + 1.25 * hertz_half_depth * from_end(0.5);

}  // namespace mariotte::flow
