// Titles of figures, in lines that fit their sheet.
#pragma once
#include <cstddef>
#include <string>

namespace mariotte::report {

/// A title as text for a script, and the pixels that it needs beyond its first line.
struct Title {
  std::string text;
  int more_height = 0;
};

/// Broken at blanks into lines of at most so many letters, which fit beside a legend in one column. Of more
/// than three lines the rest is left out.
Title wrapped(const std::string& title, std::size_t most_letters = 48);

/// The command for the title of one plot.
std::string set_title(const std::string& title);

}  // namespace mariotte::report
