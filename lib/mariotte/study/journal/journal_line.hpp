// A line of a journal: a JSON object whose first key is the CRC-32 of the text after it.
//
//     {"crc32":"89abcdef","sweep":"<what is swept>","points":1000}
//     {"crc32":"01234567","first":0,"count":2,"failed":0,"rows":"1,0.5,separated,\n2,0.25,separated,\n"}
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "mariotte/core/types.hpp"

namespace mariotte::study {

/// Results of neighbouring points, as text.
struct Rows {
  Index first = 0;
  Index count = 0;
  Index failed = 0;       ///< points without numbers
  std::string text = {};  ///< one line per point
};

/// Lines with their line break.
std::string heading_line(std::string_view identity, Index points);
std::string rows_line(const Rows& rows);

/// Whether a line without its line break is the heading of some journal.
bool is_heading(std::string_view line);

/// The rows of a line without its line break; empty if it is torn, altered, or a line of another kind.
std::optional<Rows> read_rows(std::string_view line);

}  // namespace mariotte::study
