#include "mariotte/study/sweep/design.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/study/sweep/random.hpp"

namespace mariotte::study {
namespace {

/// A value of the range at a fraction of the way; the ends are met exactly.
double between(const Range& range, double fraction) {
  if (fraction == 0) return range.from;
  if (fraction == 1) return range.to;
  return range.logarithmic ? range.from * std::pow(range.to / range.from, fraction)
                           : range.from + (range.to - range.from) * fraction;
}

double on_range(const Range& range, std::size_t parameter, Index count, Index position) {
  if (range.seed)
    return between(range, uniform(*range.seed, parameter, static_cast<std::uint64_t>(position)));
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
  if (one.range) return on_range(*one.range, parameter, axis.count, at);
  return std::get<double>(one.list[static_cast<std::size_t>(at)].value);
}

}  // namespace mariotte::study
