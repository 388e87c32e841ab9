// Two columns of numbers from a CSV file that a key names.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// A column by its name and what its numbers are.
struct ColumnName {
  std::string name;
  Dimension dimension;
};

/// Their rows [SI]. Headers read `name` or `name [unit]`; the path is relative to the scene's folder. Throws
/// SceneError and FileError.
std::vector<std::pair<double, double>> read_columns(const Source& source, const Field& path,
                                                    const ColumnName& first, const ColumnName& second);

}  // namespace mariotte::scene
