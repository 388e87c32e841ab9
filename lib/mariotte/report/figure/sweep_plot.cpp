#include "mariotte/report/figure/sweep_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/sweep_axes.hpp"
#include "mariotte/report/figure/value_axis.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_figures = 12;
constexpr Index few_points = 40;  // that marks do not hide the curve

using Columns = std::vector<study::Column>;

/// One picture, and the columns it shows.
struct Figure {
  std::string key;
  std::vector<std::size_t> columns;
};

std::string without_indices(std::string key) {
  for (auto open = key.find('['); open != std::string::npos; open = key.find('['))
    key.erase(open, key.find(']', open) + 1 - open);
  return key;
}

/// Curves of one quantity share a figure, maps cannot.
std::vector<Figure> figures_of(const Columns& columns, bool shared) {
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto key = shared ? without_indices(columns[k].key) : columns[k].key;
    auto found =
        std::find_if(figures.begin(), figures.end(), [&](const auto& one) { return one.key == key; });
    if (found == figures.end()) found = figures.insert(found, {.key = key, .columns = {}});
    found->columns.push_back(k);
  }
  return figures;
}

std::string file_name(std::string key) {
  std::replace(key.begin(), key.end(), '[', '_');
  std::erase(key, ']');
  return "sweep." + key;
}

/// Position in plot.csv, from 1: the coordinates, the parameters, the columns.
std::size_t place(const study::Design& design, std::size_t column) {
  return drawn_parameters(design).size() + design.parameters.size() + column + 1;
}

/// Without numbers, where the points stand: the axes and their numbers stay. `height` is what stands beside
/// the horizontal coordinate.
std::string unless_empty(const std::string& plot, const char* height) {
  return fmt::format(
      "if (low > high) {{ plot 'plot.csv' using 1:{} with dots lc rgb 'white' notitle }} else {{\n{}\n}}\n",
      height, plot);
}

std::string curves(const study::Design& design, const Columns& columns, const Figure& figure) {
  const auto& one = design.parameters[drawn_parameters(design)[0]];
  const bool random = one.range && one.range->seed;
  const auto* style = random ? "points ps 0.4" : design.points() <= few_points ? "linespoints" : "lines";
  std::vector<std::string> draw;
  std::vector<std::size_t> places;
  for (const auto column : figure.columns) {
    places.push_back(place(design, column));
    draw.push_back(fmt::format("'plot.csv' using 1:{} with {} lt {} title {}", scaled(places.back()), style,
                               draw.size() + 1, quoted(short_label(columns[column]))));
  }
  const bool several = draw.size() > 1;
  const auto* key = several ? "set key outside right top vertical\n" : "unset key\n";
  const auto& column = columns[figure.columns[0]];
  return fmt::format("{}unset colorbox\n", key) +
         value_axis(places, several ? figure.key : column.key, column, "y") +
         on_all_terminals(file_name(figure.key),
                          unless_empty(fmt::format("plot {}", fmt::join(draw, ", \\\n  ")), "(0)"),
                          several ? wide : one_column);
}

/// $lines, the lines of equal value; gnuplot writes them with blanks between columns, whatever it is asked.
std::string contour_table(const std::string& data, Index contours) {
  return fmt::format(
             "set contour base\nunset surface\nset cntrparam levels auto {}\nset table $contours\n"
             "splot {} notitle\nunset table\nunset contour\nset surface\n",
             contours, data) +
         R"(set print $lines
do for [i=1:|$contours|] {
  line = $contours[i]
  if (words(line) == 3) { print word(line, 1).','.word(line, 2).','.word(line, 3) } else { print '' }
}
unset print
set style textbox opaque noborder margins 0.5, 0.5
)";
}
/// White in black, with the value of each.
constexpr const char* contour_lines =
    ", \\\n  $lines using 1:2 with lines lc rgb 'black' lw 2.5 dt solid notitle"
    ", \\\n  $lines using 1:2 with lines lc rgb 'white' lw 1 dt solid notitle"
    ", \\\n  $lines using 1:2:(sprintf('{/*0.8 %.3g}', $3)) every 1000::8 with labels boxed notitle";

std::string surface(const study::Design& design, const Columns& columns, const Figure& figure,
                    const scene::Figure& options) {
  const auto& column = columns[figure.columns[0]];
  const auto at = place(design, figure.columns[0]);
  const bool lined = options.contours > 0 && is_map(design);
  const auto* style = is_map(design) ? "image" : "points pt 7 ps 0.5 lc palette";
  const auto data = "'plot.csv' using 1:2:" + scaled(at);
  const auto plot = fmt::format("plot {} with {} notitle{}", data, style, lined ? contour_lines : "");
  return "unset key\nunset grid\nset cblabel offset 0.5,0\n"
         "set rmargin at screen 0.72\n" +
         value_axis({at}, column.key, column, "cb") + (options.logarithmic ? logarithmic_colours() : "") +
         (lined ? "if (low <= high) {\n" + contour_table(data, options.contours) + "}\n" : "") +
         on_all_terminals(file_name(figure.key), unless_empty(plot, "2"), one_column);
}

std::string axes(const study::Design& design) {
  const auto drawn = drawn_parameters(design);
  auto text = axis_settings(design, drawn[0], 'x');
  return drawn.size() > 1 ? text + axis_settings(design, drawn[1], 'y') : text;
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
  plot.script = script_head() + axes(design);
  for (const auto& figure : figures) {
    plot.script += fmt::format("\nset title {} noenhanced\n", quoted(title));
    plot.script +=
        drawn.size() == 1 ? curves(design, columns, figure) : surface(design, columns, figure, options);
    const auto files = files_of_figure(file_name(figure.key));
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
    for (const auto parameter : drawn) text += fmt::format("{:.9g},", coordinate(design, parameter, point));
    text += row;
    if (is_map(design) && ends_column(design, point)) text += "\n";
  }
}

}  // namespace mariotte::report
