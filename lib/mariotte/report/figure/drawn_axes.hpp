// Which axes of a sweep a figure shows, and which of its points.
#pragma once
#include <vector>

#include "mariotte/study/sweep/design.hpp"

namespace mariotte::report {

/// Whether its values are drawn by chance.
bool is_random(const study::Parameter& parameter);

/// Numbers of the parameters that stand for the axes of a figure: one, two, or none for a sweep that has no
/// figures. Others move along with these. Axes of a single point are not drawn. The second of a family has
/// the names of its curves.
std::vector<std::size_t> drawn_parameters(const study::Design& design);

/// Whether one of two drawn parameters is a short list: it is drawn as curves over the other one.
bool is_family(const study::Design& design);

/// Whether two drawn parameters make a grid without gaps.
bool is_map(const study::Design& design);

/// Whether points in their order make a curve: not those of words, nor of numbers in no order.
bool is_curve(const study::Parameter& parameter);

/// Whether a point is in a figure: evenly spaced ones, no more than can be seen.
bool is_drawn(const study::Design& design, Index point);

/// Whether a drawn point of a map is the last one of its column.
bool ends_column(const study::Design& design, Index point);

}  // namespace mariotte::report
