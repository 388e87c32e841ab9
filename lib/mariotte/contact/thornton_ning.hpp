// Elastic, perfectly plastic spheres that adhere [Thornton & Ning 1998, Powder Technol 99:154]: the curve of
// Johnson, Kendall & Roberts until the pressure in the middle of the contact reaches p_y, at a_y; then
//
//     f = πp_y (a² − a_y²) + 4E* a_y³/(3R) − 2E* s a_y √a     with the δ(a) of the elastic curve
//
// and unloading from (a*, f*) on the elastic curve of the flattened radius R_p = (4/3) E* a*³/(f* + 2E* s
// a*^{3/2}), moved by the dent δ_p = a*² (1/R − 1/R_p). A dented contact holds better than a fresh one.
#pragma once
#include "mariotte/contact/jkr.hpp"
#include "mariotte/core/bracket.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte::contact {

struct ThorntonNing : AdhesiveStatement {
  static constexpr std::string_view name = "thornton-ning";
  AdhesiveCurve curve;  ///< of the fresh contact
  double pressure;      ///< p_y [Pa]
  double work;          ///< work of adhesion w [J/m²]
  double yield_root;    ///< √a_y

  ThorntonNing(double modulus, double radius, double p, double w)
      : curve{.modulus = modulus, .radius = radius, .s = std::sqrt(2 * std::numbers::pi * w / modulus)},
        pressure(p),
        work(w) {
    expect_numbers(name, parameters());
    find_yield();
  }
  /// In the middle of the contact, where √a = u [Pa].
  double middle_pressure(double u) const {
    return 2 * curve.modulus / std::numbers::pi * (u * u / curve.radius - curve.s / (2 * u));
  }
  void find_yield() {
    const double least = curve.snap();
    const auto excess = [&](double u) { return middle_pressure(u) / pressure - 1; };
    if (!(excess(least) < 0))
      throw InvalidParameter(
          "thornton-ning: yield_pressure is so small that the contact yields as it snaps in");
    double high = 2 * least;
    while (excess(high) < 0) high *= 2;
    yield_root = locate_sign_change(excess, least, excess(least), high, excess(high), 0);
  }

  template <class T>
  T plastic_force(const T& u) const {
    const double area = yield_root * yield_root, e = curve.modulus;
    return std::numbers::pi * pressure * (u * u * u * u - T(area * area)) +
           T(4.0 / 3.0 * e * area * area * area / curve.radius) - (2.0 * e * curve.s * area) * u;
  }
  /// The curve on which a contact unloads from √a* = u.
  AdhesiveCurve unloading(double u) const {
    const double cube = u * u * u, e = curve.modulus;
    auto flattened = curve;
    flattened.radius = 4.0 / 3.0 * e * cube * cube / (plastic_force(u) + 2 * e * curve.s * cube);
    flattened.dent = u * u * u * u * (1 / curve.radius - 1 / flattened.radius);
    return flattened;
  }
  AdhesiveCurve curve_of(const Memory& past) const {
    return past.peak > 0 ? unloading(curve.root(past.peak)) : curve;
  }

  template <class T>
  T force(const Memory& past, const T& indentation, const T&) const {
    if (past.branch == Branch::plastic) return plastic_force(curve.root(indentation));
    const auto now = curve_of(past);
    return now.force(now.root(indentation));
  }
  std::optional<WidthBranch> width_branch(const Memory& past) const {
    if (past.branch != Branch::plastic) return curve_of(past).branch();
    const double area = yield_root * yield_root, e = curve.modulus, first = std::numbers::pi * pressure;
    return WidthBranch{.curve = curve.width(),
                       .push = {4.0 / 3.0 * e * area * area * area / curve.radius - first * area * area,
                                -2 * e * curve.s * area, 0, 0, first}};
  }
  /// Stored where it is as deep as ever.
  double energy_at_peak(double u) const { return u > yield_root ? unloading(u).energy(u) : curve.energy(u); }
  double stored_energy(const Memory& past, double indentation) const {
    if (is_plastic(past, indentation, yield_indentation(past)))
      return energy_at_peak(curve.root(indentation));
    const auto now = curve_of(past);
    return now.energy(now.root(indentation));
  }
  double closing_indentation(const Memory& past) const { return curve_of(past).dent; }
  std::optional<double> rest_indentation(const Memory& past) const {
    if (past.branch == Branch::plastic) return std::nullopt;
    return curve_of(past).rest_indentation();
  }
  double natural_indentation(double stored) const {
    return indentation_of(
        curve, [&](double u) { return energy_at_peak(u); }, stored, name);
  }
  double opening_indentation(const Memory& past) const { return curve_of(past).last_indentation(); }
  double yield_indentation(const Memory&) const { return curve.indentation(yield_root); }
  /// ∫ f dδ on the plastic branch from a = 0, with its own constant.
  double plastic_work(double u) const {
    const double r = curve.radius, s = curve.s, a = u * u, ay = yield_root * yield_root;
    const double first = std::numbers::pi * pressure,
                 second = 4.0 / 3.0 * curve.modulus * ay * ay * ay / r - first * ay * ay,
                 third = 2 * curve.modulus * s * ay;
    return a * a * (0.5 * first * a * a / r - 0.2 * first * s * u + second / r - 0.8 * third * u / r) +
           s * (0.5 * third * a - second * u);
  }
  double plastic_loss(double peak) const {
    const double u = curve.root(peak);
    if (!(u > yield_root)) return 0;
    return curve.energy(yield_root) + plastic_work(u) - plastic_work(yield_root) - unloading(u).energy(u);
  }
  std::vector<LawParameter> parameters() const {
    return {{"effective_modulus", curve.modulus},
            {"effective_radius", curve.radius},
            {"yield_pressure", pressure},
            {"work_of_adhesion", work}};
  }
};

}  // namespace mariotte::contact
