#include "mariotte/report/figure/sweep_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/ticks.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

using study::Design;
using study::Parameter;

constexpr Index most_on_a_curve = 5000;
constexpr Index most_along_a_map = 200;  // 40 000 pixels of a figure of some hundred thousand
constexpr Index most_names = 12;
constexpr double most_ticks = 5;  // below a map

bool is_random(const Parameter& one) {
  return one.range && one.range->seed;
}

bool is_logarithmic(const Parameter& one) {
  return one.range && one.range->logarithmic && one.range->from > 0;
}

/// In the unit that suits what the axis shows.
Display display_of(const Parameter& one) {
  std::vector<double> ends;
  if (one.range) ends = {one.range->from, one.range->to};
  for (const auto& value : one.list)
    if (const auto* number = std::get_if<double>(&value.value)) ends.push_back(*number);
  if (one.unit.empty()) return {.factor = 1, .unit = "", .decimals = 0};
  return display_for(ends, one.unit);
}

/// Decades of a range, and what is between if there are few; what is beyond its ends would widen the margin.
std::string decades(const study::Range& range, double scale) {
  const double least = std::log10(scale * std::min(range.from, range.to)) - 1e-9;
  const double most = std::log10(scale * std::max(range.from, range.to)) + 1e-9;
  const int count = static_cast<int>(most - least);
  std::string tics;
  for (int power = static_cast<int>(std::floor(least)); power <= most; power += 1 + count / 8)
    for (const int factor : {1, 2, 5}) {
      const double at = power + std::log10(factor);
      if ((factor > 1 && count > 2) || at < least || at > most) continue;
      tics += fmt::format("{}'{:g}' {:.9g}", tics.empty() ? "" : ", ", factor * std::pow(10.0, power), at);
    }
  return tics;
}

/// One of so many positions along an axis is drawn.
Index step(const Design& design, const study::Axis& axis) {
  const Index most = design.axes.size() == 1 ? most_on_a_curve : most_along_a_map;
  return (axis.count + most - 1) / most;
}

std::string name(const scene::Node& value, std::size_t position, double factor) {
  if (const auto* number = std::get_if<double>(&value.value)) return fmt::format("{:g}", factor * *number);
  if (const auto* text = std::get_if<std::string>(&value.value)) return *text;
  if (const auto* truth = std::get_if<bool>(&value.value)) return *truth ? "true" : "false";
  return std::to_string(position);
}

std::string names(const std::vector<scene::Node>& values, double factor) {
  std::string tics;
  const std::size_t step = (values.size() + most_names - 1) / most_names;
  for (std::size_t k = 0; k < values.size(); k += step)
    tics += fmt::format("{}{} {}", k > 0 ? ", " : "", quoted(plain(name(values[k], k, factor))), k);
  return tics;
}

/// What stands along an axis, for gnuplot.
std::string ticks(const Parameter& one, double factor, char axis) {
  if (!one.range) return "(" + names(one.list, factor) + ")";
  if (is_logarithmic(one)) return "(" + decades(*one.range, factor) + ")";
  const double span = factor * std::abs(one.range->to - one.range->from) * (one.range->normal ? 3 : 1);
  return axis == 'x' && span > 0 ? fmt::format("{:g}", tick_step(span, most_ticks)) : "autofreq";
}

/// Random points leave some of their range empty at its ends.
std::string limits(const Parameter& one, double factor, char axis) {
  if (!is_random(one) || one.range->normal || is_logarithmic(one)) return "";
  const auto [least, most] = std::minmax(one.range->from, one.range->to);
  return fmt::format("set {}range [{:.9g}:{:.9g}]\n", axis, factor * least, factor * most);
}

}  // namespace

std::vector<std::size_t> drawn_parameters(const Design& design) {
  std::vector<std::size_t> first;
  for (std::size_t axis = 0; axis < design.axes.size(); ++axis)
    first.push_back(static_cast<std::size_t>(
        std::find_if(design.parameters.begin(), design.parameters.end(),
                     [&](const Parameter& one) { return one.axis == static_cast<Index>(axis); }) -
        design.parameters.begin()));
  const bool cloud = first.size() == 1 && is_random(design.parameters[0]) && design.parameters.size() > 1 &&
                     is_random(design.parameters[1]);
  if (cloud) return {0, 1};
  return first.size() <= 2 ? first : std::vector<std::size_t>{};
}

bool is_map(const Design& design) {
  const auto drawn = drawn_parameters(design);
  return drawn.size() == 2 && !is_random(design.parameters[drawn[0]]) &&
         !is_random(design.parameters[drawn[1]]);
}

bool is_drawn(const Design& design, Index point) {
  return std::all_of(design.axes.begin(), design.axes.end(), [&](const study::Axis& axis) {
    return position(axis, point) % step(design, axis) == 0;
  });
}

bool ends_column(const Design& design, Index point) {
  const auto& last = design.axes.back();
  return position(last, point) + step(design, last) >= last.count;
}

double coordinate(const Design& design, std::size_t parameter, Index point) {
  const auto& one = design.parameters[parameter];
  if (!one.range)
    return static_cast<double>(position(design.axes[static_cast<std::size_t>(one.axis)], point));
  const double value = display_of(one).factor * number(design, parameter, point);
  return is_logarithmic(one) ? std::log10(value) : value;
}

std::string axis_settings(const Design& design, std::size_t parameter, char axis) {
  const auto& one = design.parameters[parameter];
  const auto display = display_of(one);
  const auto name = one.is_variable ? plain(one.key) : name_of_input(one.key);
  return fmt::format("set {0}label {1}\nset {0}tics nomirror out {2}\nset autoscale {0}fix\n{3}", axis,
                     quoted(with_unit(name, display.unit)), ticks(one, display.factor, axis),
                     limits(one, display.factor, axis));
}

}  // namespace mariotte::report
