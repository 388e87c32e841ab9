#include "mariotte/scene/law_table.hpp"

#include "mariotte/scene/table_columns.hpp"

namespace mariotte::scene {

std::vector<contact::LawPoint> read_law_table(const Source& source, const Field& path) {
  std::vector<contact::LawPoint> points;
  for (const auto& [depth, force] :
       read_columns(source, path, {"indentation", dimension::length}, {"force", dimension::stiffness(0)}))
    points.push_back({depth, force});
  return points;
}

}  // namespace mariotte::scene
