#include "mariotte/contact/tabulated.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/core/monotone_cubic.hpp"

namespace mariotte::contact {
namespace {

void expect_rising(const std::vector<LawPoint>& points) {
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i].indentation > points[i - 1].indentation && points[i].force > points[i - 1].force) ||
        !std::isfinite(points[i].indentation + points[i].force))
      throw InvalidParameter("tabulated: point " + std::to_string(i) +
                             " does not rise: indentations and forces must grow from 0, and be finite");
}

std::vector<double> slopes(const std::vector<LawPoint>& points) {
  std::vector<double> depth, force;
  for (const auto& point : points) {
    depth.push_back(point.indentation);
    force.push_back(point.force);
  }
  return monotone_slopes(depth, force);
}

}  // namespace

Tabulated::Tabulated(std::vector<LawPoint> points) : points_(std::move(points)) {
  if (points_.empty() || points_[0].indentation != 0) points_.insert(points_.begin(), {0, 0});
  if (points_.size() < 2 || points_[0].force != 0)
    throw InvalidParameter(
        "tabulated: the force must be 0 at the indentation 0, and there must be a point more");
  expect_rising(points_);
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
