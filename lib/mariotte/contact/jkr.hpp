// Adhesive elastic spheres, with everything a function of the contact radius a:
//
//     δ = a²/R − s √a,    f = 4E* a³/(3R) − 2E* s a^{3/2} + η a δ̇,    s = √(2πw/E*)
//
// [Johnson, Kendall & Roberts 1971, Proc R Soc A 324:301]. A contact snaps in at δ = 0 and lets go at
// δ = −3a²/R with a³ = πwR²/(8E*), where dδ/da = 0 and the force is 5/9 of the largest pull. An impact loses
// 7.09 (w⁵R⁴/E*²)^{1/3} there [Thornton & Ning 1998, Powder Technol 99:154]. For soft, large bodies with much
// adhesion [Johnson & Greenwood 1997, JCIS 192:326].
#pragma once
#include <cmath>
#include <numbers>

#include "mariotte/contact/stated_law.hpp"
#include "mariotte/contact/where_reached.hpp"

namespace mariotte::contact {

/// The curve above in u = √a, in which it is a polynomial, moved by a dent.
struct AdhesiveCurve {
  double modulus;   ///< E* [Pa]
  double radius;    ///< R [m]
  double s;         ///< √(2πw/E*) [√m]
  double dent = 0;  ///< δ of the same load on the curve less that on this one [m]

  WidthCurve width() const { return {.radius = radius, .s = s, .origin = dent}; }
  /// Where it lets go, dδ/du = 0.
  double last() const { return width().last(); }
  double indentation(double u) const { return width().indentation(u); }
  /// √a where it snaps in, δ = δ₀, and indentation where its force is zero.
  double snap() const { return std::cbrt(s * radius); }
  double rest_indentation() const { return indentation(std::cbrt(1.5 * s * radius)); }
  double last_indentation() const { return width().indentation(last()); }
  WidthBranch branch() const {
    return {.curve = width(), .push = {0, 0, 0, -2 * modulus * s, 0, 0, 4.0 / 3.0 * modulus / radius}};
  }

  template <class T>
  T force(const T& u) const {
    const T cube = u * u * u;
    return modulus * (cube * ((4.0 / (3.0 * radius)) * cube - T(2.0 * s)));
  }
  /// ∫ f dδ along the curve from a = 0.
  double energy(double u) const {
    const double q = u * u * u / radius;
    return modulus * (u * u) * (u * u) * ((8.0 / 15.0) * q * q - (4.0 / 3.0) * s * q + 0.5 * s * s);
  }
  /// u of an indentation on the branch that holds; that of the end beyond it.
  double root(double indentation) const { return width().root(indentation); }
  template <class T>
  T root(const T& indentation) const {
    const double u = root(indentation.value), slope = width().slope(u);
    return T::chain(indentation, u, slope > 0 ? 1 / slope : 0);
  }
};

/// Indentation of a curve at which the energy that a function says of √a beyond the snap-in is stored.
template <class Energy>
double indentation_of(const AdhesiveCurve& curve, Energy&& energy, double stored, std::string_view law) {
  const double first = curve.snap();
  const double further = where_reached([&](double more) { return energy(first + more); }, stored, law);
  return curve.indentation(first + further);
}

struct Jkr : AdhesiveStatement {
  static constexpr std::string_view name = "jkr";
  AdhesiveCurve curve;
  double work;         ///< work of adhesion w [J/m²]
  double damping = 0;  ///< η [N s/m²]

  Jkr(double modulus, double radius, double w, double eta)
      : curve{.modulus = modulus, .radius = radius, .s = std::sqrt(2 * std::numbers::pi * w / modulus)},
        work(w),
        damping(eta) {
    expect_numbers(name, parameters());
  }
  template <class T>
  T force(const Memory&, const T& indentation, const T& rate) const {
    const T u = curve.root(indentation);
    return curve.force(u) + damping * (u * u * rate);
  }
  double stored_energy(const Memory&, double indentation) const {
    return curve.energy(curve.root(indentation));
  }
  std::optional<WidthBranch> width_branch(const Memory&) const {
    auto branch = curve.branch();
    branch.damping = damping;
    return branch;
  }
  double opening_indentation(const Memory&) const { return curve.last_indentation(); }
  std::optional<double> rest_indentation(const Memory&) const { return curve.rest_indentation(); }
  double natural_indentation(double stored) const {
    return indentation_of(
        curve, [&](double u) { return curve.energy(u); }, stored, name);
  }
  bool is_damped() const { return damping > 0; }
  std::vector<LawParameter> parameters() const {
    return {{"effective_modulus", curve.modulus},
            {"effective_radius", curve.radius},
            {"work_of_adhesion", work},
            {"damping", damping}};
  }
};

}  // namespace mariotte::contact
