// Names of curves, where they stand beside or above them.
#pragma once
#include <string>
#include <vector>

#include "mariotte/report/figure/time_figure.hpp"

namespace mariotte::report {

/// Curves that coincide, by their numbers.
using Group = std::vector<std::size_t>;

inline constexpr double invisible = 0.004;  ///< of the height of a figure

/// The vertical axis [SI].
struct Range {
  double least = 0;
  double most = 0;

  double place(double value) const { return (value - least) / (most - least); }
};

/// Which groups are named beside the right end, and which above a peak; where a panel is narrower than a
/// name, all names stand at the end, and their symbols above the peaks.
struct Naming {
  std::vector<std::size_t> at_end, at_peak;
};

/// `narrowest` is the width of a panel without names at its end [pixels].
Naming naming(const TimeFigure& figure, const std::vector<Group>& groups, const Range& range,
              double narrowest);

/// Letters of enhanced text that are seen.
std::size_t letters(const std::string& text);

/// Length of the time axis of a panel [pixels].
double sheet_pixels(const Panel& panel);

/// Pixels that names at the end need.
double margin_of(const TimeFigure& figure, const std::vector<Group>& groups,
                 const std::vector<std::size_t>& named);

/// Names beside the ends of curves, joined to them by leaders; each has a line of its own, since distances
/// between lines of one label differ among terminals.
std::string end_labels(const TimeFigure& figure, const std::vector<Group>& groups,
                       const std::vector<std::size_t>& named, const Range& range, const Panel& panel);

/// Names above the peaks that lie in this panel, or below those that point down.
std::string peak_labels(const TimeFigure& figure, const std::vector<Group>& groups, const Naming& named,
                        const Range& range, const Panel& panel);

}  // namespace mariotte::report
