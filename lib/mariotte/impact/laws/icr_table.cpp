#include "mariotte/impact/laws/icr_table.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {
namespace {

using Spacing = TableAxis::Spacing;
using Numbers = std::vector<double>;

constexpr double kinks = 2;  ///< kinks need not be parallel to an axis

double coordinate(const TableAxis& axis, double value) {
  return axis.spacing == Spacing::log ? std::log(value) : value;
}

double step(const TableAxis& axis, Index cell) {
  return coordinate(axis, axis.values[cell + 1]) - coordinate(axis, axis.values[cell]);
}

/// Where a value lies on an axis.
struct Place {
  Index cell = 0;
  double share = 0;  ///< of the way to the next value
};

Place locate(const TableAxis& axis, double value) {
  const auto& values = axis.values;
  const auto found = std::lower_bound(values.begin(), values.end(), value);
  if (found != values.end() && *found == value) return {.cell = found - values.begin()};
  if (axis.spacing == Spacing::exact)
    throw OutsideTable("the table has no point at " + axis.name + " = " + std::to_string(value));
  if (found == values.begin() || found == values.end() || std::isnan(value))
    throw OutsideTable(axis.name + " = " + std::to_string(value) + " is outside the table");
  const Index cell = found - values.begin() - 1;
  return {cell, (coordinate(axis, value) - coordinate(axis, values[cell])) / step(axis, cell)};
}

/// A corner of the cell around a point, and its weight.
struct Corner {
  std::vector<Index> node;
  double weight;
};

std::vector<Corner> corners(const IcrTable& table, const std::vector<Place>& places) {
  std::vector<Corner> all = {{{}, 1}};
  for (std::size_t a = 0; a < table.axis.size(); ++a) {
    std::vector<Corner> more;
    for (const auto& corner : all)
      for (const Index side : {0, 1}) {
        const double weight = side ? places[a].share : 1 - places[a].share;
        if (weight == 0) continue;
        auto next = corner;
        next.node.push_back(places[a].cell + side);
        next.weight *= weight;
        more.push_back(std::move(next));
      }
    all = std::move(more);
  }
  return all;
}

const TablePoint& point_at(const IcrTable& table, const std::vector<Index>& node) {
  Index place = 0;
  for (std::size_t a = 0; a < node.size(); ++a) place = place * std::ssize(table.axis[a].values) + node[a];
  const auto& point = table.point[place];
  if (point.share.empty()) throw OutsideTable("the table has no impact at or around this point");
  return point;
}

/// Shares, and the energy ratio as the last.
Numbers numbers_at(const IcrTable& table, const std::vector<Index>& node) {
  const auto& point = point_at(table, node);
  auto numbers = point.share;
  numbers.push_back(point.energy_ratio);
  return numbers;
}

/// |second derivative| along an axis at a corner of the cell, or at its neighbour inside the table.
Numbers curvature(const IcrTable& table, std::vector<Index> node, std::size_t a) {
  const auto& axis = table.axis[a];
  node[a] = std::clamp<Index>(node[a], 1, std::ssize(axis.values) - 2);
  const double before = step(axis, node[a] - 1), after = step(axis, node[a]);
  auto low = node, high = node;
  --low[a], ++high[a];
  const auto f0 = numbers_at(table, low), f1 = numbers_at(table, node), f2 = numbers_at(table, high);
  Numbers second;
  for (std::size_t i = 0; i < f1.size(); ++i)
    second.push_back(2 * std::abs((f2[i] - f1[i]) / after - (f1[i] - f0[i]) / before) / (before + after));
  return second;
}

void add_errors(Numbers& error, const IcrTable& table, const std::vector<Corner>& corners,
                const std::vector<Place>& places) {
  for (std::size_t a = 0; a < table.axis.size(); ++a) {
    const double t = places[a].share;
    if (t == 0) continue;
    const double h = step(table.axis[a], places[a].cell);
    Numbers largest(error.size(), 0.0);
    for (const auto& corner : corners) {
      const auto second = curvature(table, corner.node, a);
      for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], second[i]);
    }
    for (std::size_t i = 0; i < error.size(); ++i)
      error[i] += kinks * h * h * largest[i] * std::min(t, 1 - t);
  }
}

/// The plastic outcome where an energy ratio moved by its error is not possible.
Numbers velocities(const Configuration& c, LawParameters parameters) {
  auto outcome = multiple_impact(c, parameters);
  if (outcome.status == LawStatus::complex) {
    parameters.energy_ratio = *outcome.least_energy_ratio;
    outcome = multiple_impact(c, parameters);
  }
  return outcome.velocity;
}

}  // namespace

TableAnswer look_up(const IcrTable& table, const Numbers& at) {
  if (at.size() != table.axis.size())
    throw InvalidParameter("the table needs one value for each of its " + std::to_string(table.axis.size()) +
                           " axes");
  std::vector<Place> places;
  for (std::size_t a = 0; a < at.size(); ++a) places.push_back(locate(table.axis[a], at[a]));
  const auto around = corners(table, places);
  Numbers value(numbers_at(table, around.front().node).size(), 0.0), error(value.size(), table.accuracy);
  for (const auto& corner : around) {
    const auto numbers = numbers_at(table, corner.node);
    for (std::size_t i = 0; i < value.size(); ++i) value[i] += corner.weight * numbers[i];
  }
  add_errors(error, table, around, places);
  TableAnswer answer{.parameters = {.direction = {value.begin(), value.end() - 1},
                                    .energy_ratio = value.back(),
                                    .frame = EnergyFrame::mass_centre,
                                    .slow = std::max(rounding, table.accuracy)},
                     .share_error = {error.begin(), error.end() - 1},
                     .energy_error = error.back()};
  return answer;
}

BoundedOutcome multiple_impact(const Configuration& c, const TableAnswer& answer) {
  BoundedOutcome bounded{.outcome = multiple_impact(c, answer.parameters)};
  const auto middle = velocities(c, answer.parameters);
  Numbers error(middle.size(), 0.0);
  const auto move = [&](const LawParameters& moved_up, const LawParameters& moved_down) {
    const auto up = velocities(c, moved_up), down = velocities(c, moved_down);
    for (std::size_t i = 0; i < error.size(); ++i)
      error[i] += std::max(std::abs(up[i] - middle[i]), std::abs(down[i] - middle[i]));
  };
  for (std::size_t j = 0; j < answer.share_error.size(); ++j) {
    auto up = answer.parameters, down = up;
    up.direction[j] += answer.share_error[j];
    down.direction[j] = std::max(0.0, down.direction[j] - answer.share_error[j]);
    move(up, down);
  }
  auto up = answer.parameters, down = up;
  up.energy_ratio += answer.energy_error;
  down.energy_ratio = std::max(0.0, down.energy_ratio - answer.energy_error);
  move(up, down);
  bounded.velocity_error = *std::max_element(error.begin(), error.end());
  return bounded;
}

}  // namespace mariotte::impact
