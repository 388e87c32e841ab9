// Work–precision diagrams by gnuplot: run time against error, a figure per problem.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "measure.hpp"

namespace mariotte::work_precision {

/// Create the folder; without `force`, throw report::FileError if it holds a file that would be written.
void prepare_plots(const std::filesystem::path& folder, const std::vector<std::string>& problems, bool force);

/// Write plot.csv, plot.gp and, as PNG and SVG, a figure for every problem that has a row. Returns an empty
/// text, or why there are no figures. Throws report::FileError.
std::string write_plots(const std::filesystem::path& folder, const std::vector<Row>& rows);

}  // namespace mariotte::work_precision
