// report.html in a folder of results.
#pragma once
#include <filesystem>

#include "mariotte/report/json/json.hpp"

namespace mariotte::command {

/// Name of the page.
inline constexpr const char* report_page = "report.html";
/// Name of what its moving picture is made from.
inline constexpr const char* motion_file = "motion.json";

/// What a page of a folder tells that `run --out` or `sweep --out` has filled. Throws scene::FileError.
report::Json read_result(const std::filesystem::path& folder);

/// Write the page of a result with the figures of the folder. Throws report::FileError.
void write_report_page(const std::filesystem::path& folder, const report::Json& result);

}  // namespace mariotte::command
