#include "mariotte/report/figure/palette.hpp"

#include <fmt/format.h>

#include <numeric>
#include <vector>

namespace mariotte::report {

std::string palette_settings() {
  std::string text;
  for (std::size_t i = 0; i < std::lcm(line_colours.size(), line_dashes.size()); ++i) {
    const std::string dashes = line_dashes[i % line_dashes.size()];
    text += fmt::format("set linetype {} lc rgb '{}' lw 2 dt {} pt {} ps 0.8\n", i + 1,
                        line_colours[i % line_colours.size()], dashes.empty() ? "solid" : "(" + dashes + ")",
                        line_marks[i % line_marks.size()]);
  }
  std::vector<std::string> stops;
  for (const auto* colour : map_colours) stops.push_back(fmt::format("{} '{}'", stops.size(), colour));
  return text + fmt::format("set palette defined ({})\n", fmt::join(stops, ", "));
}

}  // namespace mariotte::report
