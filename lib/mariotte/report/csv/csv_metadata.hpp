// What a CSV file holds and where it comes from, in a file beside it, by the W3C's "Metadata Vocabulary for
// Tabular Data". The CSV itself has its names in the first line and numbers below, as its readers expect.
#pragma once
#include <filesystem>
#include <string>

#include "mariotte/report/attributes.hpp"

namespace mariotte::report {

/// "wave.csv-metadata.json", where CSV on the Web looks for it.
std::filesystem::path metadata_name(const std::filesystem::path& csv);

/// Of a trace called `file`, whose first line is `header`: names, units and meanings of its columns, and
/// `origin` as its notes.
std::string trace_metadata(const std::string& file, const std::string& header, const Attributes& origin);

}  // namespace mariotte::report
