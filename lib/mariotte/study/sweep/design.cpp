#include "mariotte/study/sweep/design.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/study/sweep/normal.hpp"
#include "mariotte/study/sweep/random.hpp"
#include "mariotte/study/sweep/sobol.hpp"

namespace mariotte::study {
namespace {

/// A value of the range at a fraction of the way, where the ends are met exactly, or of the distribution.
double between(const Range& range, double fraction) {
  if (range.normal) return mean(range) + deviation(range) * normal_quantile(fraction);
  if (fraction == 0) return range.from;
  if (fraction == 1) return range.to;
  return range.logarithmic ? range.from * std::pow(range.to / range.from, fraction)
                           : range.from + (range.to - range.from) * fraction;
}

/// Which of the coordinates of Sobol's points along its axis a parameter has.
std::size_t coordinate(const Design& design, std::size_t parameter) {
  const auto& parameters = design.parameters;
  return std::count_if(parameters.begin(), parameters.begin() + parameter, [&](const Parameter& one) {
    return one.axis == parameters[parameter].axis && one.range && one.range->draw == Draw::sobol;
  });
}

/// How far between the ends a value is drawn, in [0, 1).
double drawn(const Design& design, std::size_t parameter, Index count, Index position) {
  const auto& range = *design.parameters[parameter].range;
  const auto place = static_cast<std::uint64_t>(position);
  const double jitter = uniform(*range.seed, parameter, place);
  switch (range.draw) {
    case Draw::independent:
      return jitter;
    case Draw::latin: {
      const auto all = static_cast<std::uint64_t>(count);
      return (static_cast<double>(shuffled(*range.seed, parameter, all, place)) + jitter) /
             static_cast<double>(all);
    }
    case Draw::sobol:
      return sobol(*range.seed, coordinate(design, parameter), place);
  }
  return jitter;
}

double on_range(const Design& design, std::size_t parameter, Index count, Index position) {
  const auto& range = *design.parameters[parameter].range;
  if (range.seed) return between(range, drawn(design, parameter, count, position));
  return count == 1 ? range.from
                    : between(range, static_cast<double>(position) / static_cast<double>(count - 1));
}

}  // namespace

std::vector<std::string> keys(const Design& design) {
  std::vector<std::string> all;
  for (const auto& parameter : design.parameters) all.push_back(parameter.key);
  return all;
}

Index position(const Axis& axis, Index point) {
  return point / axis.stride % axis.count;
}

bool is_numeric(const Parameter& parameter) {
  return std::all_of(parameter.list.begin(), parameter.list.end(),
                     [](const scene::Node& node) { return std::holds_alternative<double>(node.value); });
}

scene::Node value(const Design& design, std::size_t parameter, Index point) {
  const auto& one = design.parameters[parameter];
  if (one.range) return {number(design, parameter, point), one.place};
  return one.list[static_cast<std::size_t>(position(design.axes[one.axis], point))];
}

double number(const Design& design, std::size_t parameter, Index point) {
  const auto& one = design.parameters[parameter];
  const auto& axis = design.axes[one.axis];
  const Index at = position(axis, point);
  if (one.range) return on_range(design, parameter, axis.count, at);
  return std::get<double>(one.list[static_cast<std::size_t>(at)].value);
}

double number(const Design& design, const Formula& formula, Index point, std::span<const double> result) {
  std::vector<double> numbers;
  for (const auto& [kind, which, constant] : formula.terms) switch (kind) {
      case Term::Kind::constant:
        numbers.push_back(constant);
        break;
      case Term::Kind::parameter:
        numbers.push_back(number(design, which, point));
        break;
      case Term::Kind::derived:
        numbers.push_back(number(design, design.derived[which].formula, point));
        break;
      case Term::Kind::result:
        numbers.push_back(result[which]);
        break;
    }
  return formula.expression(numbers);
}

}  // namespace mariotte::study
