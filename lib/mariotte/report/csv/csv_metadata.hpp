// What a CSV file holds and where it comes from, in a file beside it, by the W3C's "Metadata Vocabulary for
// Tabular Data". The CSV itself has its names in the first line and numbers below, as its readers expect.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "mariotte/impact/quantities/description.hpp"
#include "mariotte/report/attributes.hpp"

namespace mariotte::report {

/// "wave.csv-metadata.json", where CSV on the Web looks for it.
std::filesystem::path metadata_name(const std::filesystem::path& csv);

/// Of a trace called `file`, whose first line is `header`: names and units of its columns, the meanings of
/// those that are `known`, and `origin` as its notes.
std::string trace_metadata(const std::string& file, const std::string& header, const Attributes& origin,
                           std::span<const impact::Description> known = impact::sampled);

}  // namespace mariotte::report
