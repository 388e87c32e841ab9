// Names of lines whose data gnuplot alone reads: beside their ends, or below the figure for want of room.
#pragma once
#include <string>
#include <vector>

#include "mariotte/report/figure/gnuplot.hpp"

namespace mariotte::report {

/// A line, and what it is called; both `abscissa` and `height` are gnuplot's expressions of a row of `data`.
struct NamedLine {
  std::string data;
  std::string abscissa;
  std::string height;
  std::string name;
};

/// Whether the names, and what stands above them, leave room for the lines.
bool fit_beside(const std::vector<NamedLine>& lines, const std::string& heading);

/// gnuplot commands that put a name of its colour beside the right end of each line. They follow those that
/// set `low`, `high`, the values that the lines span [SI], `factor`, by which these are multiplied, and
/// `margin`, what a flat figure has above and below them, else 0; logarithmic axes come after them.
std::string names_beside(const std::vector<NamedLine>& lines, const std::string& heading);

/// gnuplot commands for a legend below a figure, and the sheet of a figure that has `names` there.
std::string names_below(const std::string& heading);
Sheet sheet_with_names(std::size_t names);

}  // namespace mariotte::report
