// Pictures of sweeps by gnuplot.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sweep.hpp"

namespace mariotte::stiffness_study {

/// Curves of one quantity over the value that was varied.
struct Figure {
  enum class Quantity { seconds, steps, first_icr };
  std::string name;  ///< of the files, without ending
  std::string title;
  std::string along;  ///< name and unit of what was varied
  Quantity quantity;
  std::string Row::*curve;  ///< what tells curves apart
  Rows rows;
};

/// One figure per series of the rows, a curve per flow.
std::vector<Figure> figures_by_flow(const Rows& rows, const std::string& along, Figure::Quantity quantity);

/// Write plot.csv and plot.gp into `folder` and run gnuplot. Returns an empty text, or why there are no
/// figures. Throws report::FileError.
std::string draw(const std::filesystem::path& folder, const std::vector<Figure>& figures);

}  // namespace mariotte::stiffness_study
