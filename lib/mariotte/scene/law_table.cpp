#include "mariotte/scene/law_table.hpp"

#include "mariotte/scene/table_columns.hpp"

namespace mariotte::scene {

std::vector<contact::LawPoint> read_law_table(const Source& source, const Field& path) {
  std::vector<contact::LawPoint> points;
  const auto columns =
      read_columns(source, path, {"indentation", dimension::length}, {"force", dimension::stiffness(0)});
  for (const auto& row : columns.rows) points.push_back({row.first, row.second});
  if (const auto fall = contact::first_fall(points))
    reject(columns.file, columns.rows[*fall].place, fault::impossible, std::string(contact::rule_of_points));
  return points;
}

}  // namespace mariotte::scene
