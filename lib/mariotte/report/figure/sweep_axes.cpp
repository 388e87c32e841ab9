#include "mariotte/report/figure/sweep_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/drawn_axes.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/ticks.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

using study::Design;
using study::Parameter;

constexpr Index most_tick_names = 12;
constexpr double most_ticks = 5;                           // below a map
constexpr double letters_below = 34, letters_beside = 60;  // of a logarithmic axis, whose lines are not long

bool is_logarithmic(const Parameter& one) {
  return one.range && one.range->logarithmic && one.range->from > 0;
}

/// In the unit that suits what the axis shows.
Display display_of(const Parameter& one) {
  if (one.unit == "rad") return {.factor = 180 / std::numbers::pi, .unit = "deg", .decimals = 0};
  std::vector<double> ends;
  if (one.range) ends = {one.range->from, one.range->to};
  for (const auto& value : one.list)
    if (const auto* number = std::get_if<double>(&value.value)) ends.push_back(*number);
  if (one.unit.empty()) return {.factor = 1, .unit = "", .decimals = 0};
  return display_for(ends, one.unit);
}

/// Round numbers of a range, which stand at their logarithms.
std::string logarithmic(const study::Range& range, double scale, double letters) {
  std::string tics;
  const auto [least, most] = std::minmax(range.from, range.to);
  for (const double at : logarithmic_ticks(scale * least, scale * most, letters))
    tics += fmt::format("{}'{:g}' {:.9g}", tics.empty() ? "" : ", ", at, std::log10(at));
  return tics;
}

std::string name(const scene::Node& value, std::size_t position, double factor) {
  if (const auto* number = std::get_if<double>(&value.value)) return tick_name(factor * *number);
  if (const auto* text = std::get_if<std::string>(&value.value)) return *text;
  if (const auto* truth = std::get_if<bool>(&value.value)) return *truth ? "true" : "false";
  return std::to_string(position);
}

std::string names(const Parameter& one) {
  const auto names = value_names(one);
  std::string tics;
  const std::size_t step = (names.size() + most_tick_names - 1) / most_tick_names;
  for (std::size_t k = 0; k < names.size(); k += step)
    tics += fmt::format("{}{} {}", k > 0 ? ", " : "", quoted(names[k]), k);
  return tics;
}

/// A list that stands along an axis by its numbers.
bool is_to_scale(const Design& design, std::size_t parameter) {
  return study::is_numeric(design.parameters[parameter]) && !is_map(design) &&
         drawn_parameters(design)[0] == parameter;
}

/// What stands along an axis, for gnuplot.
std::string ticks(const Design& design, std::size_t parameter, double factor, char axis) {
  const auto& one = design.parameters[parameter];
  if (!one.range) return is_to_scale(design, parameter) ? "autofreq" : "(" + names(one) + ")";
  if (is_logarithmic(one))
    return "(" + logarithmic(*one.range, factor, axis == 'x' ? letters_below : letters_beside) + ")";
  const double span = factor * std::abs(one.range->to - one.range->from) * (one.range->normal ? 3 : 1);
  return axis == 'x' && span > 0 ? fmt::format("{:g}", tick_step(span, most_ticks)) : "autofreq";
}

/// Where all points stand, if that is one place.
std::optional<double> only_place(const Design& design, std::size_t parameter) {
  const double first = coordinate(design, parameter, 0);
  for (Index point = 1; point < design.points(); ++point)
    if (coordinate(design, parameter, point) != first) return std::nullopt;
  return first;
}

/// Random points leave some of their range empty at its ends; around one place gnuplot knows none.
std::string limits(const Design& design, std::size_t parameter, double factor, char axis) {
  const auto range = [axis](double least, double most) {
    return fmt::format("set {}range [{:.9g}:{:.9g}]\n", axis, least, most);
  };
  if (const auto place = only_place(design, parameter)) {
    const double room = *place == 0 ? 1 : 0.01 * std::abs(*place);
    return range(*place - room, *place + room);
  }
  const auto& one = design.parameters[parameter];
  if (!is_random(one) || one.range->normal || is_logarithmic(one)) return "";
  const auto [least, most] = std::minmax(one.range->from, one.range->to);
  return range(factor * least, factor * most);
}

}  // namespace

double coordinate(const Design& design, std::size_t parameter, Index point) {
  const auto& one = design.parameters[parameter];
  if (!one.range && !is_to_scale(design, parameter))
    return static_cast<double>(position(design.axes[static_cast<std::size_t>(one.axis)], point));
  const double value = display_of(one).factor * number(design, parameter, point);
  return is_logarithmic(one) ? std::log10(value) : value;
}

std::string axis_settings(const Design& design, std::size_t parameter, char axis) {
  const auto& one = design.parameters[parameter];
  const double factor = display_of(one).factor;
  return fmt::format("set {0}label {1}\nset {0}tics nomirror out {2}\nset autoscale {0}fix\n{3}", axis,
                     quoted(axis_name(one)), ticks(design, parameter, factor, axis),
                     limits(design, parameter, factor, axis));
}

std::string parameter_name(const Parameter& one) {
  return one.is_variable ? greek(one.key)
                         : name_of_input(one.key_in_results.empty() ? one.key : one.key_in_results);
}

std::string axis_name(const Parameter& one) {
  return with_unit(parameter_name(one), display_of(one).unit);
}

std::vector<std::string> value_names(const Parameter& one) {
  std::vector<std::string> names;
  const double factor = display_of(one).factor;
  for (const auto& value : one.list) names.push_back(plain(name(value, names.size(), factor)));
  return names;
}

}  // namespace mariotte::report
