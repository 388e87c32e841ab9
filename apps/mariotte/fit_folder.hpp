// What `mariotte fit --out DIR` leaves in DIR.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mariotte/report/figure/fit_plot.hpp"

namespace mariotte::command {

/// Names of all files that a fit may leave in its folder.
std::vector<std::string> fit_names();

/// Create the folder; without `force`, throw report::FileError if it holds a file that would be written.
void prepare_fit_folder(const std::filesystem::path& folder, bool force);

/// Write the fit and draw its figures, replacing those of an earlier fit. Returns an empty text, or why there
/// are no figures. Throws report::FileError.
std::string write_fit_folder(const std::filesystem::path& folder, const report::FitReport& report,
                             const std::optional<study::FitCurves>& curves);

}  // namespace mariotte::command
