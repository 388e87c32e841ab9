// Elastic, perfectly plastic spheres: Hertz until the pressure reaches p_y, then a pressure that is cut off
// there [Thornton 1997, J Appl Mech 64:383],
//
//     δ_y = R (πp_y/(2E*))²,   f = f_y + πp_y R (δ − δ_y),   unloading: f = (4/3) E* √R_p (δ − δ_p)^{3/2}
//
// with R_p = R f_e/f*, δ_p = δ* (1 − f*/f_e), and f_e the Hertz force at the largest indentation δ*.
#pragma once
#include <cmath>
#include <numbers>

#include "mariotte/contact/stated_law.hpp"

namespace mariotte::contact {

struct Thornton : YieldingStatement {
  static constexpr std::string_view name = "thornton";
  double modulus;   ///< E* [Pa]
  double radius;    ///< R [m]
  double pressure;  ///< p_y [Pa]

  Thornton(double e, double r, double p) : modulus(e), radius(r), pressure(p) {
    expect_numbers(name, parameters());
  }
  /// Where it yields [m].
  double limit() const {
    const double strain = std::numbers::pi * pressure / (2 * modulus);
    return radius * strain * strain;
  }
  double hertz(double r) const { return 4.0 / 3.0 * modulus * std::sqrt(r); }
  double slope() const { return std::numbers::pi * pressure * radius; }
  double yield_force() const { return hertz(radius) * limit() * std::sqrt(limit()); }
  double plastic_force(double d) const { return yield_force() + slope() * (d - limit()); }
  /// f*/f_e.
  double softening(double peak) const {
    return plastic_force(peak) / (hertz(radius) * peak * std::sqrt(peak));
  }
  /// f_e ≥ f* but for rounding; goes on smoothly to peaks below the limit, so that it has slopes there.
  double dent(double peak) const { return peak > 0 ? peak * std::max(0.0, 1 - softening(peak)) : 0; }

  template <class T>
  T force(const Memory& past, const T& indentation, const T&) const {
    using std::sqrt;
    if (past.branch == Branch::plastic) return T(yield_force()) + slope() * (indentation - T(limit()));
    const bool dented = past.branch == Branch::unloading;
    const T left = indentation - T(dented ? dent(past.peak) : 0);
    if (!(left > 0.0)) return T(0.0);
    return hertz(dented ? radius / softening(past.peak) : radius) * (left * sqrt(left));
  }
  std::optional<ShiftedPower> power(const Memory& past) const {
    if (past.branch == Branch::plastic) return ShiftedPower{slope(), 1, limit() - yield_force() / slope()};
    if (past.branch == Branch::elastic) return ShiftedPower{hertz(radius), 1.5, 0};
    return ShiftedPower{hertz(radius / softening(past.peak)), 1.5, dent(past.peak)};
  }
  double stored_energy(const Memory& past, double d) const {
    if (is_plastic(past, d, limit())) return 0.4 * plastic_force(d) * (d - dent(d));
    const bool dented = past.branch == Branch::unloading;
    const double left = std::max(0.0, d - (dented ? dent(past.peak) : 0));
    return 0.4 * hertz(dented ? radius / softening(past.peak) : radius) * left * left * std::sqrt(left);
  }
  double closing_indentation(const Memory& past) const { return dent(past.peak); }
  double yield_indentation(const Memory&) const { return limit(); }
  double plastic_loss(double peak) const {
    const double deeper = peak - limit();
    if (!(deeper > 0)) return 0;
    return 0.4 * yield_force() * limit() + (yield_force() + 0.5 * slope() * deeper) * deeper -
           0.4 * plastic_force(peak) * (peak - dent(peak));
  }
  std::vector<LawParameter> parameters() const {
    return {{"effective_modulus", modulus}, {"effective_radius", radius}, {"yield_pressure", pressure}};
  }
};

}  // namespace mariotte::contact
