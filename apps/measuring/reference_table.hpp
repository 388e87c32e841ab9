// The stored references: CSV tables with a first line that says where they come from.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace mariotte::measuring {

using Fields = std::vector<std::string>;

/// Rows of a table without its comments (#) and its header; fields as they stand.
std::vector<Fields> rows(std::string_view csv);

/// A decimal string to more digits than a double holds.
long double number(const std::string& field);

/// Those of a row from one field on.
std::vector<long double> numbers(const Fields& row, std::size_t from);

}  // namespace mariotte::measuring
