#include "mariotte/report/figure/sweep_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/figure/drawn_axes.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_letters_of_file = 100;  // file systems take 255

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
         c == '_';
}

}  // namespace

std::string file_name(const std::string& key, const std::vector<std::string>& taken) {
  std::string name = "sweep.";
  for (const char c : key.substr(0, most_letters_of_file))
    if (c != ']') name += is_plain(c) ? c : '_';
  auto own = name;
  for (int k = 2; std::find(taken.begin(), taken.end(), own) != taken.end(); ++k)
    own = fmt::format("{}_{}", name, k);
  return own;
}

std::size_t place(const study::Design& design, std::size_t column) {
  return drawn_parameters(design).size() + design.parameters.size() + column + 1;
}

std::string unless_empty(const std::string& plot, const char* height) {
  return fmt::format(
      "if (low > high) {{ plot 'plot.csv' using 1:{} with dots lc rgb 'white' notitle }} else {{\n{}\n}}\n",
      height, plot);
}

bool is_surface(const study::Design& design) {
  return drawn_parameters(design).size() > 1 && !is_family(design);
}

}  // namespace mariotte::report
