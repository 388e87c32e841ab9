#include "mariotte/report/figure/title.hpp"

#include <sstream>
#include <vector>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/figure/gnuplot.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_title_lines = 3;
constexpr int title_line_height = 16;  ///< pixels

std::vector<std::string> lines_of(const std::string& title, std::size_t most_letters) {
  std::vector<std::string> lines{""};
  std::istringstream words(title);
  for (std::string word; words >> word;)
    if (lines.back().empty())
      lines.back() = word;
    else if (width(lines.back()) + 1 + width(word) <= most_letters)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  return lines;
}

}  // namespace

Title wrapped(const std::string& title, std::size_t most_letters) {
  auto lines = lines_of(title, most_letters);
  if (lines.size() > most_title_lines) {
    lines.resize(most_title_lines);
    lines.back() += " …";
  }
  Title made{quoted(lines.front())};
  for (std::size_t k = 1; k < lines.size(); ++k) {
    made.text += ".\"\\n\"." + quoted(lines[k]);
    made.more_height += title_line_height;
  }
  return made;
}

std::string set_title(const std::string& title) {
  return "\nset title " + wrapped(title).text + " noenhanced\n";
}

}  // namespace mariotte::report
