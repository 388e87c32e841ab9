#include "mariotte/report/figure/sweep_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/figure/drawn_axes.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/sweep_axes.hpp"
#include "mariotte/report/figure/sweep_figure.hpp"
#include "mariotte/report/figure/title.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_figures = 12;

std::string without_indices(std::string key) {
  for (auto open = key.find('['); open != std::string::npos; open = key.find('['))
    key.erase(open, key.find(']', open) + 1 - open);
  return key;
}

/// Curves of one quantity share a figure, maps cannot.
std::vector<SweepFigure> figures_of(const Columns& columns, bool shared) {
  std::vector<SweepFigure> figures;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto key = shared ? without_indices(columns[k].key) : columns[k].key;
    auto found =
        std::find_if(figures.begin(), figures.end(), [&](const auto& one) { return one.key == key; });
    if (found == figures.end()) found = figures.insert(found, {.key = key, .columns = {}});
    found->columns.push_back(k);
  }
  return figures;
}

void name_files(std::vector<SweepFigure>& figures) {
  std::vector<std::string> taken;
  for (auto& figure : figures) taken.push_back(figure.file = file_name(figure.key, taken));
}

std::string axes(const study::Design& design) {
  const auto drawn = drawn_parameters(design);
  const auto text = axis_settings(design, drawn[0], 'x');
  return is_surface(design) ? text + axis_settings(design, drawn[1], 'y') : text;
}

}  // namespace

SweepPlot sweep_plot(const study::Design& design, const Columns& columns, const std::string& title,
                     const scene::Figure& options) {
  const auto drawn = drawn_parameters(design);
  if (drawn.empty()) return {{}, "", "a sweep along three axes or more is not drawn"};
  auto figures = figures_of(columns, drawn.size() == 1);
  SweepPlot plot;
  if (figures.size() > most_figures) {
    plot.shortfall = fmt::format("only the first {} are drawn", most_figures);
    figures.resize(most_figures);
  }
  name_files(figures);
  plot.script = script_head() + axes(design);
  for (const auto& figure : figures) {
    plot.script += set_title(title);
    plot.script +=
        is_surface(design) ? surface(design, columns, figure, options) : curves(design, columns, figure);
    const auto files = files_of_figure(figure.file);
    plot.figures.insert(plot.figures.end(), files.begin(), files.end());
  }
  return plot;
}

void append_drawn(const study::Design& design, Index first, std::string_view rows, std::string& text) {
  const auto drawn = drawn_parameters(design);
  for (Index point = first; !rows.empty(); ++point) {
    const auto row = rows.substr(0, rows.find('\n') + 1);
    rows.remove_prefix(row.size());
    if (!is_drawn(design, point)) continue;
    for (const auto parameter : drawn) text += rounded(coordinate(design, parameter, point), 9) + ",";
    text += row;
    if (is_map(design) && ends_column(design, point)) text += "\n";
  }
}

}  // namespace mariotte::report
