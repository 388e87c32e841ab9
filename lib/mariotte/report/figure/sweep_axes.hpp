// Along which axes a sweep is drawn, and where on them its points stand.
#pragma once
#include <string>
#include <vector>

#include "mariotte/study/sweep/design.hpp"

namespace mariotte::report {

/// Numbers of the parameters that stand for the axes of a figure: one, two, or none for a sweep that has no
/// figures. Others move along with these.
std::vector<std::size_t> drawn_parameters(const study::Design& design);

/// Whether two drawn parameters make a grid without gaps.
bool is_map(const study::Design& design);

/// Whether a point is in a figure: evenly spaced ones, no more than can be seen.
bool is_drawn(const study::Design& design, Index point);

/// Whether a drawn point of a map is the last one of its column.
bool ends_column(const study::Design& design, Index point);

/// Where a point stands along a parameter, in even steps: its value in the unit of the axis, the logarithm to
/// base 10 of it, or the position in a list.
double coordinate(const study::Design& design, std::size_t parameter, Index point);

/// gnuplot's settings of an axis, 'x' or 'y': what it shows and what is written along it.
std::string axis_settings(const study::Design& design, std::size_t parameter, char axis);

}  // namespace mariotte::report
