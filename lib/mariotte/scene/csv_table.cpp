#include "mariotte/scene/csv_table.hpp"

#include <string_view>

namespace mariotte::scene {
namespace {

constexpr std::string_view row_blanks = " \t\r";
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// What is left of one line.
class Line {
 public:
  Line(const Source& source, std::string_view text, int number)
      : source_(source), text_(text), rest_(text), number_(number) {}

  std::vector<Cell> cells() {
    std::vector<Cell> all = {cell()};
    while (rest_.starts_with(',')) {
      rest_.remove_prefix(1);
      all.push_back(cell());
    }
    return all;
  }

 private:
  Place place() const {
    return {.line = number_, .column = static_cast<int>(text_.size() - rest_.size()) + 1};
  }

  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(row_blanks), rest_.size())); }

  Cell cell() {
    skip_blanks();
    if (rest_.starts_with('"')) return quoted();
    const auto found = rest_.substr(0, rest_.find(','));
    Cell cell{.text = std::string(found.substr(0, found.find_last_not_of(row_blanks) + 1)), .place = place()};
    rest_.remove_prefix(found.size());
    return cell;
  }

  Cell quoted() {
    Cell cell{.text = "", .place = place()};
    do {
      rest_.remove_prefix(1);
      const auto end = rest_.find('"');
      if (end == std::string_view::npos)
        reject(source_, cell.place, fault::no_table, "the quote has no end on its line");
      cell.text += rest_.substr(0, end);
      rest_.remove_prefix(end + 1);
      if (rest_.starts_with('"')) cell.text += '"';
    } while (rest_.starts_with('"'));
    skip_blanks();
    if (!rest_.empty() && rest_.front() != ',')
      reject(source_, place(), fault::no_table, "expected a comma after the quote");
    return cell;
  }

  const Source& source_;
  std::string_view text_, rest_;
  int number_;
};

bool says_nothing(std::string_view line) {
  const auto first = line.find_first_not_of(row_blanks);
  return first == std::string_view::npos || line[first] == '#';
}

void add(const Source& source, std::vector<Cell> cells, CsvTable& table) {
  if (table.header.empty()) {
    const auto other = cells.size() == 1 ? cells[0].text.find_first_of(";\t") : std::string::npos;
    if (other != std::string::npos)
      reject(source, cells[0].place, fault::no_table,
             "cells are separated by commas, not by semicolons or tabs, and decimals by points");
    table.header = std::move(cells);
    return;
  }
  if (cells.size() != table.header.size())
    reject(source, cells.front().place, fault::no_table,
           "the row has " + std::to_string(cells.size()) + " cells, the header " +
               std::to_string(table.header.size()));
  table.rows.push_back(std::move(cells));
}

}  // namespace

CsvTable parse_csv(const Source& source, const std::string& text) {
  CsvTable table;
  std::string_view rest = text;
  if (rest.starts_with(byte_order_mark)) rest.remove_prefix(byte_order_mark.size());
  for (int number = 1; !rest.empty(); ++number) {
    const auto line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (!says_nothing(line)) add(source, Line(source, line, number).cells(), table);
  }
  if (table.header.empty()) reject(source, Place{}, fault::no_table, "the table is empty");
  return table;
}

}  // namespace mariotte::scene
