// Many balls or contacts over time as an image, where curves would cover each other.
#pragma once
#include <string>
#include <vector>

#include "mariotte/report/figure/time_figure.hpp"

namespace mariotte::report {

/// An image over time and number, in colours of even lightness.
struct HeatMap {
  std::string file;  ///< without its ending
  std::string title;
  std::string along;                       ///< the vertical axis: "ball i"
  std::string quantity;                    ///< of the colours, with its symbol: "force f"
  std::string unit;                        ///< SI
  std::vector<double> time;                ///< [s]
  std::vector<std::vector<double>> value;  ///< a row per time
  std::vector<Index> number = {};          ///< of each row along the vertical axis; empty: from 1
  bool logarithmic = false;                ///< four decades of magnitudes; even colours if all is within one
};

/// The cells of each panel as a block of numbers, one line per instant: of all values within a cell the one
/// of the greatest magnitude, so that no thin pulse falls between cells.
std::string heat_map_data(const HeatMap& map, const TimeAxis& axis);

/// gnuplot commands that make the figure in colours from the least to the greatest value that it shows, or
/// from zero where that is near. They follow `script_head`; its blocks in plot.csv begin at `block`.
std::string script(const HeatMap& map, const TimeAxis& axis, std::size_t block);

}  // namespace mariotte::report
