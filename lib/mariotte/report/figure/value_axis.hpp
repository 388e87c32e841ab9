// The axis or colour bar of a sweep's outcome, in the unit that suits what its figure shows; gnuplot finds
// that out, since rows of a sweep come one by one.
#pragma once
#include <string>
#include <vector>

#include "mariotte/study/sweep/columns.hpp"

namespace mariotte::report {

/// Words and symbol beside an axis that shows columns like this one; `key` is theirs, without indices of
/// several: "final velocity v_{3}".
std::string long_label(const std::string& key, const study::Column& column);

/// What a legend calls a column: "v_{3}".
std::string short_label(const study::Column& column);

/// gnuplot's settings of an axis, "y" or "cb", that shows the columns of plot.csv at `places`, all like
/// `column`; `key` is theirs, without indices of several. Differences that are rounding are not magnified,
/// and a figure without any number says so. Sets `low` and `high`, SI, with `low` above if there are none.
std::string value_axis(const std::vector<std::size_t>& places, const std::string& key,
                       const study::Column& column, const std::string& axis);

/// Logarithmic colours where all is positive, to follow `value_axis`: ticks at 1, 2 and 5 of each decade;
/// within less than one of them, at even steps.
std::string logarithmic_colours();

/// What gnuplot draws of the column at `place`, on this axis; an empty cell is a gap.
std::string scaled(std::size_t place);

}  // namespace mariotte::report
