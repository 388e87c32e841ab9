// Tables of cells separated by commas (CSV) that remember where their cells were written.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/source.hpp"

namespace mariotte::scene {

struct Cell {
  std::string text;  ///< without blanks and quotes around it
  Place place;
};

/// Each row has as many cells as the header.
struct CsvTable {
  std::vector<Cell> header;
  std::vector<std::vector<Cell>> rows;
};

/// The first line is the header; blank lines and those that begin with # are left out. A cell between double
/// quotes may hold commas, and quotes that are doubled. Throws SceneError "name:line:column: message".
CsvTable parse_csv(const Source& source, const std::string& text);

}  // namespace mariotte::scene
