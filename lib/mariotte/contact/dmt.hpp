// A Hertz contact with a constant pull outside of it, f = (4/3) E* √R δ^{3/2} − 2πwR + c √δ δ̇ for δ > 0
// [Derjaguin, Muller & Toporov 1975, J Colloid Interface Sci 53:314, in the form of Maugis 1992, JCIS
// 150:243].
//
// The force jumps by 2πwR where the contact closes and where it opens, at δ = 0 both: without damping nothing
// is lost. For stiff, small bodies with little adhesion [Johnson & Greenwood 1997, JCIS 192:326].
#pragma once
#include <numbers>

#include "mariotte/contact/stated_law.hpp"

namespace mariotte::contact {

struct Dmt : AdhesiveStatement {
  static constexpr std::string_view name = "dmt";
  double modulus;      ///< E* [Pa]
  double radius;       ///< R [m]
  double work;         ///< work of adhesion w [J/m²]
  double damping = 0;  ///< c [N s/m^{3/2}]

  Dmt(double e, double r, double w, double c) : modulus(e), radius(r), work(w), damping(c) {
    expect_numbers(name, parameters());
  }
  double stiffness() const { return 4.0 / 3.0 * modulus * std::sqrt(radius); }
  double pull() const { return 2 * std::numbers::pi * work * radius; }

  template <class T>
  T force(const Memory&, const T& indentation, const T& rate) const {
    using std::sqrt;
    if (!(indentation > 0.0)) return T(-pull());
    return sqrt(indentation) * (stiffness() * indentation + damping * rate) - T(pull());
  }
  double stored_energy(const Memory&, double d) const {
    return d > 0 ? (0.4 * stiffness() * d * std::sqrt(d) - pull()) * d : 0;
  }
  std::optional<double> rest_indentation(const Memory&) const {
    const double root = std::cbrt(pull() / stiffness());
    return root * root;
  }
  std::optional<ShiftedPower> power(const Memory&) const {
    return ShiftedPower{stiffness(), 1.5, 0, damping, pull()};
  }
  bool is_damped() const { return damping > 0; }
  std::vector<LawParameter> parameters() const {
    return {{"effective_modulus", modulus},
            {"effective_radius", radius},
            {"work_of_adhesion", work},
            {"damping", damping}};
  }
};

}  // namespace mariotte::contact
