// What a reproduction prints and writes.
#pragma once
#include <filesystem>
#include <string>

#include "figure.hpp"

namespace mariotte::paper_figures {

/// Every check and claim.
std::string details(const Figure& figure, const Reproduction& result);

/// How many checks hold, those that do not, and the claims.
std::string summary(const Figure& figure, const Reproduction& result);

/// Files of a figure in its folder.
std::vector<std::string> file_names(const Figure& figure);

/// Write data, script, checks and picture into the figure's folder, which was prepared. Returns an empty
/// text, or why there is no picture. Throws report::FileError.
std::string write(const std::filesystem::path& folder, const Figure& figure, const Reproduction& result);

}  // namespace mariotte::paper_figures
