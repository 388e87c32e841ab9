// A law by points (δ, f) of a curve, joined by cubics that are monotone wherever the points are [Fritsch &
// Butland 1984, SIAM J Sci Stat Comput 5:300]. Beyond the last point the force goes on straight.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "mariotte/contact/custom_law.hpp"

namespace mariotte::contact {

/// A measured or computed point.
struct LawPoint {
  double indentation;  ///< [m]
  double force;        ///< [N]
};

/// What its points must do.
inline constexpr std::string_view rule_of_points =
    "indentations and forces must grow from (0, 0) on, and be finite";

/// Number, from 0, of the first point that breaks this rule.
std::optional<std::size_t> first_fall(const std::vector<LawPoint>& points);

/// An elastic law, the same for loading and unloading.
class Tabulated final : public CustomLaw {
 public:
  /// Points in ascending order, of positive indentations and rising forces; the curve begins at (0, 0), which
  /// may be the first. Throws InvalidParameter.
  explicit Tabulated(std::vector<LawPoint> points);

  std::string_view name() const override { return "tabulated"; }
  Force force(double indentation, double rate) const override;
  double stored_energy(double indentation) const override;
  const CubicCurve* curve() const override { return &curve_; }
  std::vector<LawParameter> parameters() const override;

 private:
  CubicCurve curve_;            ///< between the points, and beyond
  std::vector<double> energy_;  ///< stored where each segment begins [J]
};

}  // namespace mariotte::contact
