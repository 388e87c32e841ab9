// The catalogue of errors, doc/errors.md, which is part of the program.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace mariotte::command {

/// A section of the page.
struct ErrorEntry {
  std::string_view group;  ///< heading of the part it stands in
  std::string_view code;   ///< "S010"
  std::string_view title;
  std::string text;  ///< without the marks that only a browser understands
};

/// All, in the order of the page.
std::vector<ErrorEntry> error_catalogue();

}  // namespace mariotte::command
