// Where along the axes of a figure the points of a sweep stand, and what is written beside them.
#pragma once
#include <string>
#include <vector>

#include "mariotte/study/sweep/design.hpp"

namespace mariotte::report {

/// Where a point stands along a parameter: its value in the unit of the axis, the logarithm to base 10 of it,
/// or the position in a list of words, of a map, or of the names of curves.
double coordinate(const study::Design& design, std::size_t parameter, Index point);

/// gnuplot's settings of an axis, 'x' or 'y': what it shows and what is written along it.
std::string axis_settings(const study::Design& design, std::size_t parameter, char axis);

/// What a parameter is, with its symbol: "gap g_{2}".
std::string parameter_name(const study::Parameter& parameter);

/// The same with the unit; and its values, as they name curves.
std::string axis_name(const study::Parameter& parameter);
std::vector<std::string> value_names(const study::Parameter& parameter);

}  // namespace mariotte::report
