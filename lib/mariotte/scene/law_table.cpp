#include "mariotte/scene/law_table.hpp"

#include <filesystem>

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

Column find_column(const Source& file, const std::vector<Cell>& header, const std::string& name) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto& text = header[i].text;
    if (text == name) return {i, ""};
    if (text.starts_with(name + " [") && text.ends_with(']'))
      return {i, text.substr(name.size() + 2, text.size() - name.size() - 3)};
  }
  reject(file, header.front().place, fault::missing, "the column '" + name + "' is missing");
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

}  // namespace

std::vector<contact::LawPoint> read_law_table(const Source& source, const Field& path) {
  const auto name = std::filesystem::path(source.name).parent_path() / text(source, path);
  const Source file{.name = name.string(), .origins = {}};
  const auto table = parse_csv(file, read_text(file.name));
  const auto depth = find_column(file, table.header, "indentation"),
             force = find_column(file, table.header, "force");
  std::vector<contact::LawPoint> points;
  for (const auto& row : table.rows)
    points.push_back(
        {value(file, row, depth, dimension::length), value(file, row, force, dimension::stiffness(0))});
  return points;
}

}  // namespace mariotte::scene
