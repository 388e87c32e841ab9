#include "mariotte/report/figure/line_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/figure/curve_labels.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_beside = 10, most_letters_beside = 22, names_of_a_row = 3;
constexpr double leader_width = 14, height_of_row = 18;  // pixels

std::size_t longest(const std::vector<NamedLine>& lines, const std::string& heading) {
  auto most = letters(heading);
  for (const auto& line : lines) most = std::max(most, letters(line.name));
  return most;
}

/// Where the last point of a line lies; a gap is none.
std::string end_of(const NamedLine& line, std::size_t number) {
  return fmt::format(
      "at = -1e300; end = 0\nstats [*:*] [*:*] {} using (last_of({}, {})) nooutput\n"
      "At[{}] = at; End[{}] = end; Place[{}] = (end - bottom) / (top - bottom)\n",
      line.data, line.abscissa, line.height, number, number, number);
}

/// Names part until they are a line apart, in the order of the ends.
constexpr const char* spread_places = R"(do for [pass=1:60] { do for [i=1:|Place|] {
  do for [j=1:|Place|] {
    lies_above = i != j && (End[i] > End[j] || (End[i] == End[j] && i < j))
    push = lies_above ? 0.5 * (space - Place[i] + Place[j]) : 0
    if (push > 1e-4) { Place[i] = Place[i] + push; Place[j] = Place[j] - push }
  }
  Place[i] = Place[i] > highest ? highest : Place[i] < 0 ? 0 : Place[i]
} }
)";

std::string name_of(const NamedLine& line, std::size_t number) {
  return fmt::format(
      "if (At[{0}] > -1e300) {{\n"
      "  set arrow from At[{0}], End[{0}] to graph 1 + beside, graph Place[{0}] nohead lc rgb '#9aa5b1' lw "
      "0.7 dt "
      "solid\n"
      "  set label {1} at graph 1.01 + beside, graph Place[{0}] left front textcolor lt {0}\n}}\n",
      number, quoted(line.name), number);
}

}  // namespace

bool fit_beside(const std::vector<NamedLine>& lines, const std::string& heading) {
  return lines.size() <= most_beside && longest(lines, heading) <= most_letters_beside;
}

std::string names_beside(const std::vector<NamedLine>& lines, const std::string& heading) {
  const double margin = leader_width + 12 + letter_width * static_cast<double>(longest(lines, heading));
  std::string text = fmt::format(
      "unset key\nunset arrow\nset rmargin at screen {:.4f}\narray At[{}]; array End[{}]; array Place[{}]\n"
      "room = margin > 0 ? margin : 0.04 * (high - low)\nbottom = factor * (low - room); top = factor * "
      "(high + room)\n"
      "if (low <= high) {{ set yrange [bottom:top] }} else {{ bottom = 0; top = 1 }}\n"
      "last_of(x, y) = y == y && x >= at ? (at = x, end = y, 0) : 0\n"
      "space = 0.075; highest = {}; beside = 0.05\n",
      1 - margin / one_column.width, lines.size(), lines.size(), lines.size(), heading.empty() ? 1 : 0.88);
  for (std::size_t k = 0; k < lines.size(); ++k) text += end_of(lines[k], k + 1);
  text += spread_places;
  for (std::size_t k = 0; k < lines.size(); ++k) text += name_of(lines[k], k + 1);
  if (heading.empty()) return text;
  return text + fmt::format("set label {} at graph 1.01 + beside, graph 0.98 left\n", quoted(heading));
}

std::string names_below(const std::string& heading) {
  return fmt::format("unset arrow\nset rmargin\nset key below left horizontal title {}\n", quoted(heading));
}

Sheet sheet_with_names(std::size_t names) {
  const auto rows = static_cast<double>((names + names_of_a_row - 1) / names_of_a_row);
  return {one_column.width, one_column.height + static_cast<int>(height_of_row * rows)};
}

}  // namespace mariotte::report
