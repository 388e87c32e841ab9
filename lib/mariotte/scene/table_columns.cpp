#include "mariotte/scene/table_columns.hpp"

#include <filesystem>
#include <optional>

#include "mariotte/core/quantity.hpp"
#include "mariotte/scene/csv_table.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/text_file.hpp"

namespace mariotte::scene {
namespace {

/// A column and the unit of its header, "name [unit]"; SI without one.
struct Column {
  std::size_t number;
  std::string unit;
};

/// The column that a header describes, if it is that of `name`.
std::optional<Column> column_of(const std::string& header, std::size_t number, const std::string& name) {
  if (header == name) return Column{number, ""};
  if (!header.starts_with(name + " [") || !header.ends_with(']')) return {};
  return Column{number, header.substr(name.size() + 2, header.size() - name.size() - 3)};
}

Column find_column(const Source& file, const std::vector<Cell>& header, const std::string& name) {
  std::optional<Column> found;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto column = column_of(header[i].text, i, name);
    if (found && column) reject(file, header[i].place, fault::contradiction, "'" + name + "' is given, too");
    if (column) found = column;
  }
  if (!found) reject(file, header.front().place, fault::missing, "the column '" + name + "' is missing");
  return *found;
}

double value(const Source& file, const std::vector<Cell>& row, const Column& column,
             const Dimension& dimension) {
  const auto& cell = row[column.number];
  try {
    return parse_quantity(column.unit.empty() ? cell.text : cell.text + " " + column.unit, dimension);
  } catch (const QuantityError& error) {
    reject(file, cell.place, error.fault, error.what());
  }
}

/// What keeps a table from being read is told at the key that names it.
std::string text_of(const Source& source, const Field& path, const std::string& name) try {
  return read_text(name);
} catch (const FileError& error) {
  throw FileError(where(source, path.place()) + ": " + path.path + ": " + error.what(), error.path,
                  error.number);
}

}  // namespace

Columns read_columns(const Source& source, const Field& path, const ColumnName& first,
                     const ColumnName& second) {
  const auto name = std::filesystem::path(source.name).parent_path() / text(source, path);
  const Source file{.name = name.string(), .origins = {}};
  const auto table = parse_csv(file, text_of(source, path, file.name));
  const auto left = find_column(file, table.header, first.name),
             right = find_column(file, table.header, second.name);
  std::vector<ColumnsRow> rows;
  for (const auto& row : table.rows)
    rows.push_back({.first = value(file, row, left, first.dimension),
                    .second = value(file, row, right, second.dimension),
                    .place = row.front().place});
  return {file, rows};
}

}  // namespace mariotte::scene
