// Sweeps of a few points, and what gnuplot makes of them.
#pragma once
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "mariotte/report/figure/drawn_axes.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/sweep_plot.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::test {

using study::Design;
namespace fs = std::filesystem;

inline study::Parameter ranged(const std::string& key, Index axis, study::Range range) {
  return {.key = key, .axis = axis, .range = range};
}

inline Design curve(Index count) {
  return {.parameters = {ranged("a", 0, {.from = 0, .to = 1})}, .axes = {{.count = count, .stride = 1}}};
}

inline Design map(Index along_x, Index along_y) {
  return {.parameters = {ranged("a", 0, {.from = 0.1, .to = 10, .logarithmic = true}),
                         ranged("b", 1, {.from = 0, .to = 1})},
          .axes = {{.count = along_x, .stride = along_y}, {.count = along_y, .stride = 1}}};
}

inline Design cloud(Index count) {
  return {.parameters = {ranged("a", 0, {.from = 0, .to = 1, .seed = 1}),
                         ranged("b", 0, {.from = 0, .to = 1, .seed = 1})},
          .axes = {{.count = count, .stride = 1}}};
}

inline study::Parameter listed(const std::string& key, Index axis, const std::vector<double>& values) {
  study::Parameter one{.key = key, .axis = axis};
  for (const double value : values) one.list.emplace_back().value = value;
  return one;
}

/// What gnuplot made of a sweep, and its complaint.
struct Drawing {
  std::string svg;  ///< the first figure
  std::string problem;
};

inline std::string content(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Of a sweep with one row per point; the cells of every other point may differ.
inline Drawing drawing(const Design& design, const std::vector<study::Column>& columns,
                       const std::string& cells, std::string others = "", const scene::Figure& options = {}) {
  if (others.empty()) others = cells;
  std::string folder = (fs::temp_directory_path() / "mariotte-XXXXXX").string();
  ::mkdtemp(folder.data());
  std::string rows, data;
  for (Index point = 0; point < design.points(); ++point)
    rows += std::string(design.parameters.size(), ',') + (point % 2 == 0 ? cells : others) + "\n";
  report::append_drawn(design, 0, rows, data);
  const auto plot = report::sweep_plot(design, columns, "It's a title", options);
  report::write_file(fs::path(folder) / "plot.csv", data);
  report::write_file(fs::path(folder) / "plot.gp", plot.script);
  Drawing made{.svg = {}, .problem = report::draw(folder, plot.figures)};
  for (const auto& figure : plot.figures)
    if (made.problem.empty() && fs::file_size(fs::path(folder) / figure) < 1000)
      made.problem = figure + " is empty";
  if (made.problem.empty()) made.svg = content(fs::path(folder) / plot.figures[2]);
  fs::remove_all(folder);
  if (made.problem == "gnuplot is not installed") made.problem.clear();
  return made;
}

using Columns = std::vector<study::Column>;

inline std::string drawn(const Design& design, const Columns& columns, const std::string& cells,
                         const std::string& others = "", const scene::Figure& options = {}) {
  return drawing(design, columns, cells, others, options).problem;
}

}  // namespace mariotte::test
