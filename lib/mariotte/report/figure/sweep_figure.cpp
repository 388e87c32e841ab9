#include "mariotte/report/figure/sweep_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/figure/drawn_axes.hpp"

namespace mariotte::report {

std::string file_name(const SweepFigure& figure) {
  auto key = figure.key;
  std::replace(key.begin(), key.end(), '[', '_');
  std::erase(key, ']');
  return "sweep." + key;
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
