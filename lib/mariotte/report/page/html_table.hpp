// Tables of a page: what a result says, with symbols and units above its columns.
#pragma once
#include <string>
#include <vector>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// Where a value stands in a result, for the list of quantities: "chain" and "contacts[].impulse".
struct Key {
  std::string model;
  std::string path;
};

/// Any value as a table: one line per member of an object, per object of a list, or per number. Columns with
/// nothing in them are left out, and those of objects with nothing but zeros are named below. Numbers have
/// four digits and a unit that suits them; all digits of a number in that unit are its title, which browsers
/// show under the pointer and `copied_digits` copies.
std::string table(const Json& value, const Key& key = {});

/// A column of a table of one's own.
struct Column {
  std::string name;  ///< without its unit
  std::string unit;  ///< SI; empty or "1" for none
  Json values;       ///< a list: numbers, words, or lists of numbers
};

/// Columns of one length side by side, lines numbered from 1, or by `numbers`, below `head`.
std::string table(const std::string& head, const std::vector<Column>& columns,
                  const std::vector<std::size_t>& numbers = {});

/// Places of the contacts of a result that carried force, among all that might.
std::vector<std::size_t> closed_among(const Json& contacts);

/// A number with four digits and its unit, as in "16.34 mJ".
std::string quantity(double value, const std::string& unit);

}  // namespace mariotte::report
