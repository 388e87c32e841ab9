// Figures of a sweep by gnuplot: curves along one axis, maps over two, clouds of random points.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/study/sweep/columns.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::report {

/// What is drawn, and from what.
struct SweepPlot {
  std::vector<std::string> figures;  ///< file names, all of which begin with "sweep."
  std::string script;                ///< plot.gp, which reads plot.csv in its folder
  std::string shortfall;             ///< why not all columns are drawn; empty if they are
};

/// One axis makes a curve per column, those of one quantity in one figure; two, of which one is a short list,
/// a curve per value of the list. Other two make a map per column; if one of them is random, or random values
/// of several keys go along one axis, a cloud of points in its colours. `figure` asks for contours and
/// logarithmic colours of maps; a column that is not positive keeps even ones.
SweepPlot sweep_plot(const study::Design& design, const std::vector<study::Column>& columns,
                     const std::string& title, const scene::Figure& figure = {});

/// Appends to plot.csv what it shows of the rows from `first` on: where each point stands, and its row.
/// An empty line ends each column of a map.
void append_drawn(const study::Design& design, Index first, std::string_view rows, std::string& text);

}  // namespace mariotte::report
