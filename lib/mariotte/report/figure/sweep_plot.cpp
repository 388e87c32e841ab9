#include "mariotte/report/figure/sweep_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/sweep_axes.hpp"

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

/// What stands beside the axis of these columns: key, symbol and unit.
std::string label(const std::string& key, const study::Column& column) {
  const auto symbol = column.symbol.empty() ? "" : fmt::format("  {}", column.symbol);
  return key + symbol + (column.unit.empty() || column.unit == "1" ? "" : fmt::format(" [{}]", column.unit));
}

/// Position in plot.csv, from 1: the coordinates, the parameters, the columns.
std::size_t place(const study::Design& design, std::size_t column) {
  return drawn_parameters(design).size() + design.parameters.size() + column + 1;
}

/// Takes the range of what is shown; that of the figure before would hide numbers from `stats`. Differences
/// that are rounding are not magnified, and a figure without any number says so.
std::string range_settings(const std::vector<std::size_t>& places, const char* axis) {
  return fmt::format(R"(set autoscale {0}
low = 1e300; high = -1e300
do for [c in '{1}'] {{
  undefine S_*
  stats 'plot.csv' using (column(int(c))) name 'S' nooutput
  if (exists('S_records')) {{ low = S_min < low ? S_min : low; high = S_max > high ? S_max : high }}
}}
size = abs(low) > abs(high) ? abs(low) : abs(high)
margin = high - low > 1e-9 * size ? 0 : size > 0 ? 0.001 * size : 1
if (margin > 0) {{ set {0}range [low-margin:high+margin] }}
unset label
if (low > high) {{ set label 'no numbers' at graph 0.5, 0.5 center }}
)",
                     axis, fmt::join(places, " "));
}

std::string unless_empty(const std::string& plot) {
  return fmt::format("if (low > high) {{ plot [0:1] [0:1] 2 notitle }} else {{\n{}\n}}\n", plot);
}

std::string curves(const study::Design& design, const Columns& columns, const Figure& figure) {
  const auto& one = design.parameters[drawn_parameters(design)[0]];
  const bool random = one.range && one.range->seed;
  const auto* style = random ? "points ps 0.4" : design.points() <= few_points ? "linespoints" : "lines";
  std::vector<std::string> draw;
  std::vector<std::size_t> places;
  for (const auto column : figure.columns) {
    places.push_back(place(design, column));
    draw.push_back(fmt::format("'plot.csv' using 1:{} with {} lt {} title {} noenhanced", places.back(),
                               style, draw.size() + 1, quoted(columns[column].key)));
  }
  const bool several = draw.size() > 1;
  const auto* key = several ? "set key outside right top vertical\n" : "unset key\n";
  return fmt::format("set ylabel {} noenhanced\n{}unset colorbox\n",
                     quoted(label(figure.key, columns[figure.columns[0]])), key) +
         range_settings(places, "y") +
         on_all_terminals(file_name(figure.key),
                          unless_empty(fmt::format("plot {}", fmt::join(draw, ", \\\n  "))),
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
  const auto column = place(design, figure.columns[0]);
  const bool lined = options.contours > 0 && is_map(design);
  const auto* style = is_map(design) ? "image" : "points pt 7 ps 0.5 lc palette";
  const auto data = fmt::format("'plot.csv' using 1:2:(valid({0}) ? column({0}) : NaN)", column);
  const auto plot = fmt::format("plot {} with {} notitle{}", data, style, lined ? contour_lines : "");
  return fmt::format(
             "unset key\nunset grid\nset autoscale fix\nset lmargin at screen 0.16\nset rmargin at screen "
             "0.75\n"
             "set cblabel {} noenhanced offset 1.2,0\n",
             quoted(label(figure.key, columns[figure.columns[0]]))) +
         range_settings({column}, "cb") +
         (options.logarithmic ? "if (low > 0) { set logscale cb } else { unset logscale cb }\n" : "") +
         (lined ? unless_empty(contour_table(data, options.contours)) : "") +
         on_all_terminals(file_name(figure.key), unless_empty(plot), one_column);
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
