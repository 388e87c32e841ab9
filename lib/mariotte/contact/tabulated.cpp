#include "mariotte/contact/tabulated.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/core/monotone_cubic.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::contact {
namespace {

constexpr LawPoint origin{.indentation = 0, .force = 0};

std::vector<double> slopes(const std::vector<LawPoint>& points) {
  std::vector<double> depth, force;
  for (const auto& point : points) {
    depth.push_back(point.indentation);
    force.push_back(point.force);
  }
  return monotone_slopes(depth, force);
}

/// With these slopes at its ends.
CubicSegment joined(const LawPoint& one, const LawPoint& next, double slope, double next_slope) {
  const double h = next.indentation - one.indentation, secant = (next.force - one.force) / h;
  return {.from = one.indentation,
          .to = next.indentation,
          .a = {one.force, slope, (3 * secant - 2 * slope - next_slope) / h,
                (slope + next_slope - 2 * secant) / (h * h)}};
}

}  // namespace

std::optional<std::size_t> first_fall(const std::vector<LawPoint>& points) {
  const bool starts = !points.empty() && points[0].indentation == 0 && points[0].force == 0;
  for (std::size_t i = starts ? 1 : 0; i < points.size(); ++i) {
    const auto &one = points[i], &before = i == 0 ? origin : points[i - 1];
    if (!(one.indentation > before.indentation && one.force > before.force) ||
        !std::isfinite(one.indentation + one.force))
      return i;
  }
  return {};
}

Tabulated::Tabulated(std::vector<LawPoint> points) {
  if (const auto fall = first_fall(points))
    throw InvalidParameter("tabulated: point " + std::to_string(*fall + 1) + ": " +
                           std::string(rule_of_points));
  if (points.empty() || points[0].indentation != 0) points.insert(points.begin(), origin);
  if (points.size() < 2) throw InvalidParameter("tabulated: there must be a point beyond (0, 0)");
  const auto slope = slopes(points);
  energy_.push_back(0);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto& segment = curve_.emplace_back(joined(points[i], points[i + 1], slope[i], slope[i + 1]));
    energy_.push_back(energy_.back() + segment.energy(segment.to));
  }
  const auto& last = points.back();
  curve_.push_back({.from = last.indentation, .to = infinity, .a = {last.force, slope.back(), 0, 0}});
}

Force Tabulated::force(double indentation, double) const {
  const auto& segment = segment_at(curve_, indentation);
  return {.value = segment.force(indentation), .by_indentation = segment.slope(indentation), .by_rate = 0};
}

double Tabulated::stored_energy(double indentation) const {
  const auto& segment = segment_at(curve_, indentation);
  return energy_[static_cast<std::size_t>(&segment - curve_.data())] + segment.energy(indentation);
}

std::vector<LawParameter> Tabulated::parameters() const {
  const auto& last = curve_.back();
  return {{"points", static_cast<double>(curve_.size())},
          {"largest_indentation", last.from},
          {"largest_force", last.a[0]}};
}

}  // namespace mariotte::contact
