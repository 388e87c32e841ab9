// One figure of a sweep.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/figure.hpp"
#include "mariotte/study/sweep/columns.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::report {

using Columns = std::vector<study::Column>;

/// One picture, and the columns it shows.
struct SweepFigure {
  std::string key;
  std::string file = {};  ///< its name without ending
  std::vector<std::size_t> columns;
};

/// "sweep.icr_0" for the key icr[0], without its ending: letters, digits, points, minus and underscores, not
/// among the names that are taken.
std::string file_name(const std::string& key, const std::vector<std::string>& taken);

/// Position of a column in plot.csv, from 1: the coordinates, the parameters, the columns.
std::size_t place(const study::Design& design, std::size_t column);

/// Without numbers, where the points stand: the axes and their numbers stay. `height` is what stands beside
/// the horizontal coordinate.
std::string unless_empty(const std::string& plot, const char* height);

/// Whether colours show the numbers, over two axes.
bool is_surface(const study::Design& design);

/// gnuplot commands that draw numbers over one axis, as a curve per column or per value of a short list.
std::string curves(const study::Design& design, const Columns& columns, const SweepFigure& figure);

/// Numbers over two axes, as colours.
std::string surface(const study::Design& design, const Columns& columns, const SweepFigure& figure,
                    const scene::Figure& options);

}  // namespace mariotte::report
