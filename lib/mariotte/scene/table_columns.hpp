// Two columns of numbers from a CSV file that a key names.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// A column by its name and what its numbers are.
struct ColumnName {
  std::string name;
  Dimension dimension;
};

/// One row [SI] and where it is.
struct ColumnsRow {
  double first, second;
  Place place;
};

struct Columns {
  Source file;
  std::vector<ColumnsRow> rows;
};

/// Their rows. Headers read `name` or `name [unit]`; the path is relative to the scene's folder. Throws
/// SceneError and FileError.
Columns read_columns(const Source& source, const Field& path, const ColumnName& first,
                     const ColumnName& second);

}  // namespace mariotte::scene
