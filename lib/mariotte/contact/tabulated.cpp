#include "mariotte/contact/tabulated.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/core/monotone_cubic.hpp"

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

Tabulated::Tabulated(std::vector<LawPoint> points) : points_(std::move(points)) {
  if (const auto fall = first_fall(points_))
    throw InvalidParameter("tabulated: point " + std::to_string(*fall + 1) + ": " +
                           std::string(rule_of_points));
  if (points_.empty() || points_[0].indentation != 0) points_.insert(points_.begin(), origin);
  if (points_.size() < 2) throw InvalidParameter("tabulated: there must be a point beyond (0, 0)");
  slope_ = slopes(points_);
  energy_.assign(points_.size(), 0);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double h = points_[i].indentation - points_[i - 1].indentation;
    energy_[i] = energy_[i - 1] +
                 h * (0.5 * (points_[i].force + points_[i - 1].force) + h * (slope_[i - 1] - slope_[i]) / 12);
  }
}

/// The piece that holds an indentation, or the last point beyond all.
std::size_t Tabulated::piece_of(double indentation) const {
  const auto above = std::upper_bound(points_.begin(), points_.end(), indentation,
                                      [](double d, const LawPoint& p) { return d < p.indentation; });
  return above == points_.begin() ? 0 : static_cast<std::size_t>(above - points_.begin()) - 1;
}

Force Tabulated::force(double indentation, double) const {
  const std::size_t i = piece_of(indentation);
  const auto& from = points_[i];
  const double x = indentation - from.indentation, rate = slope_[i];
  if (i + 1 == points_.size()) return {.value = from.force + rate * x, .by_indentation = rate, .by_rate = 0};
  const double h = points_[i + 1].indentation - from.indentation,
               secant = (points_[i + 1].force - from.force) / h;
  const double square = (3 * secant - 2 * rate - slope_[i + 1]) / h,
               cube = (rate + slope_[i + 1] - 2 * secant) / (h * h);
  return {.value = from.force + x * (rate + x * (square + x * cube)),
          .by_indentation = rate + x * (2 * square + 3 * x * cube),
          .by_rate = 0};
}

double Tabulated::stored_energy(double indentation) const {
  const std::size_t i = piece_of(indentation);
  const double x = indentation - points_[i].indentation;
  const auto end = force(indentation, 0);
  return energy_[i] + x * (0.5 * (points_[i].force + end.value) + x * (slope_[i] - end.by_indentation) / 12);
}

std::vector<LawParameter> Tabulated::parameters() const {
  return {{"points", static_cast<double>(points_.size())},
          {"largest_indentation", points_.back().indentation},
          {"largest_force", points_.back().force}};
}

}  // namespace mariotte::contact
