#include "mariotte/report/csv/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mariotte::report {
namespace {

constexpr Index rows_before_gap = 24;
constexpr Index rows_after_gap = 12;
constexpr std::size_t runs_shown = 6;

std::string aligned(const TableRow& row, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i)
    line += "  " + std::string(widths[i] - width(row[i]), ' ') + row[i];
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::vector<std::size_t> widths_of(const std::vector<TableRow>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  return widths;
}

// One past the last position of the run of consecutive numbers that starts at `first`.
std::size_t run_end(const std::vector<Index>& positions, std::size_t first) {
  std::size_t next = first + 1;
  while (next < positions.size() && positions[next] == positions[next - 1] + 1) ++next;
  return next;
}

std::vector<std::string> runs_of(const std::vector<Index>& positions) {
  std::vector<std::string> runs;
  for (std::size_t first = 0; first < positions.size();) {
    const std::size_t next = run_end(positions, first);
    runs.push_back(next - first == 1 ? fmt::format("{}", positions[first] + 1)
                                     : fmt::format("{}–{}", positions[first] + 1, positions[next - 1] + 1));
    first = next;
  }
  return runs;
}

}  // namespace

std::string columns(const TableRow& header, Index count, const std::function<TableRow(Index)>& row) {
  const bool whole = count <= most_rows;
  const Index head = whole ? count : rows_before_gap;
  std::vector<TableRow> rows = {header};
  for (Index i = 0; i < head; ++i) rows.push_back(row(i));
  for (Index i = whole ? count : count - rows_after_gap; i < count; ++i) rows.push_back(row(i));

  const auto widths = widths_of(rows);
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!whole && static_cast<Index>(i) == head + 1)
      text += fmt::format("  ⋮ {} more\n", count - rows_before_gap - rows_after_gap);
    text += aligned(rows[i], widths);
  }
  return text;
}

std::string numbers(const std::vector<Index>& positions) {
  const auto runs = runs_of(positions);
  if (runs.size() <= runs_shown) return fmt::format("{}", fmt::join(runs, " "));
  return fmt::format("{} … {} ({} in all)", fmt::join(runs.begin(), runs.begin() + runs_shown - 2, " "),
                     runs.back(), positions.size());
}

std::string heading(const std::string& title) {
  std::string text = title + "\n";
  for (std::size_t left = width(title); left > 0; --left) text += "═";
  return text + "\n";
}

std::string line(const std::string& name, const std::string& value, const std::string& note) {
  return fmt::format("  {:<24}{:>16}{}{}\n", name, value, note.empty() ? "" : "  ", note);
}

std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace mariotte::report
