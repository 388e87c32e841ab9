// The law of microbodies [Brach & Dunn, as in Cheng 2002] for contacts of any bodies, f = (4/3) E* √R δ^{3/2}
// (1 + C_H δ̇) − 2π f₀ √(Rδ) (1 − C_A δ̇) for δ > 0, with f₀ = (9 K R w²/2π)^{1/3}, K = (4/3) E*.
//
// It closes and opens at δ = 0 without a jump. Without damping nothing is lost.
#pragma once
#include "mariotte/contact/brach_dunn.hpp"
#include "mariotte/contact/stated_law.hpp"

namespace mariotte::contact {

struct BrachDunnLaw : AdhesiveStatement {
  static constexpr std::string_view name = "brach-dunn";
  double modulus;  ///< E* [Pa]
  double radius;   ///< R [m]
  double work;     ///< work of adhesion w [J/m²]
  BrachDunn tip;   ///< what follows from them, and C_H and C_A

  BrachDunnLaw(double e, double r, double w, double damping_hertz, double damping_adhesion)
      : modulus(e),
        radius(r),
        work(w),
        tip(brach_dunn({.stiffness = 4.0 / 3.0 * e, .adhesion = w}, r, damping_hertz, damping_adhesion)) {
    expect_numbers(name, parameters());
  }

  template <class T>
  T force(const Memory&, const T& indentation, const T& rate) const {
    return normal_force(tip, indentation, T(-1.0 * rate));
  }
  double stored_energy(const Memory&, double d) const { return d > 0 ? contact::stored_energy(tip, d) : 0; }
  std::optional<BrachDunn> adhesive_tip() const { return tip; }
  std::optional<double> rest_indentation(const Memory&) const { return contact::rest_indentation(tip); }
  bool is_damped() const { return tip.damping_hertz > 0 || tip.damping_adhesion > 0; }
  std::vector<LawParameter> parameters() const {
    return {{"effective_modulus", modulus},
            {"effective_radius", radius},
            {"work_of_adhesion", work},
            {"damping_hertz", tip.damping_hertz},
            {"damping_adhesion", tip.damping_adhesion}};
  }
};

}  // namespace mariotte::contact
