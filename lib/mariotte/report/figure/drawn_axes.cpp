#include "mariotte/report/figure/drawn_axes.hpp"

#include <algorithm>
#include <utility>

namespace mariotte::report {
namespace {

using study::Design;
using study::Parameter;

constexpr Index most_on_a_curve = 5000;
constexpr Index most_along_a_map = 200;      // 40 000 pixels of a figure of some hundred thousand
constexpr std::size_t most_of_a_family = 7;  // lines that are told apart

/// One of so many positions along an axis is drawn.
Index step(const Design& design, const study::Axis& axis) {
  const Index most = design.axes.size() == 1 ? most_on_a_curve : most_along_a_map;
  return (axis.count + most - 1) / most;
}

bool is_short_list(const Parameter& one) {
  return !one.range && one.list.size() <= most_of_a_family;
}

/// The first parameter of each axis that has several points; of the first axis if none has.
std::vector<std::size_t> first_parameters(const Design& design) {
  std::vector<std::size_t> first;
  for (std::size_t axis = 0; axis < design.axes.size(); ++axis) {
    if (design.axes[axis].count == 1 && design.points() > 1) continue;
    const auto is_of_axis = [&](const Parameter& one) { return one.axis == static_cast<Index>(axis); };
    first.push_back(static_cast<std::size_t>(
        std::find_if(design.parameters.begin(), design.parameters.end(), is_of_axis) -
        design.parameters.begin()));
  }
  if (design.points() == 1) first.resize(1);
  return first;
}

}  // namespace

bool is_random(const Parameter& one) {
  return one.range && one.range->seed;
}

std::vector<std::size_t> drawn_parameters(const Design& design) {
  auto first = first_parameters(design);
  const bool cloud = first.size() == 1 && is_random(design.parameters[0]) && design.parameters.size() > 1 &&
                     is_random(design.parameters[1]);
  if (cloud) return {0, 1};
  if (first.size() == 2 && is_short_list(design.parameters[first[0]])) std::swap(first[0], first[1]);
  return first.size() <= 2 ? first : std::vector<std::size_t>{};
}

bool is_family(const Design& design) {
  const auto drawn = drawn_parameters(design);
  return drawn.size() == 2 && is_short_list(design.parameters[drawn[1]]);
}

bool is_curve(const Parameter& one) {
  if (one.range) return !is_random(one);
  const auto descends = [](const scene::Node& a, const scene::Node& b) {
    return std::get<double>(a.value) > std::get<double>(b.value);
  };
  return study::is_numeric(one) &&
         std::adjacent_find(one.list.begin(), one.list.end(), descends) == one.list.end();
}

bool is_map(const Design& design) {
  const auto drawn = drawn_parameters(design);
  return drawn.size() == 2 && !is_random(design.parameters[drawn[0]]) &&
         !is_random(design.parameters[drawn[1]]) && !is_short_list(design.parameters[drawn[1]]);
}

bool is_drawn(const Design& design, Index point) {
  return std::all_of(design.axes.begin(), design.axes.end(), [&](const study::Axis& axis) {
    return position(axis, point) % step(design, axis) == 0;
  });
}

bool ends_column(const Design& design, Index point) {
  const auto& last =
      design.axes[static_cast<std::size_t>(design.parameters[drawn_parameters(design)[1]].axis)];
  return position(last, point) + step(design, last) >= last.count;
}

}  // namespace mariotte::report
