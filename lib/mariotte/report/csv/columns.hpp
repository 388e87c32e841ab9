// Plain text in columns, short enough to read however long the data are.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::report {

using TableRow = std::vector<std::string>;

/// At most this many rows are shown of anything; the middle of a longer list is left out.
inline constexpr Index most_rows = 40;

/// Lines of right-aligned cells under `header`, for rows 0 … count−1. From more than `most_rows` rows the
/// middle is replaced by one line that says how many are missing.
std::string columns(const TableRow& header, Index count, const std::function<TableRow(Index)>& row);

/// Positions (from 0) as numbers from 1, runs joined: {0, 1, 2, 5} is "1–3 6". Left out in the middle if
/// long.
std::string numbers(const std::vector<Index>& positions);

/// A title, underlined.
std::string heading(const std::string& title);

/// One line of a balance: a name, what it is worth, and perhaps a word on it.
std::string line(const std::string& name, const std::string& value, const std::string& note = "");

/// Columns a terminal needs for UTF-8 text without wide characters.
std::size_t width(const std::string& text);

}  // namespace mariotte::report
