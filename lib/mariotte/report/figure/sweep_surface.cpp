#include <fmt/format.h>

#include "mariotte/report/figure/drawn_axes.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/sweep_figure.hpp"
#include "mariotte/report/figure/value_axis.hpp"

namespace mariotte::report {
namespace {

/// $lines, the lines of equal value, and $names, a point of each that is off those of the others; gnuplot
/// writes lines with blanks between columns, whatever it is asked.
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
set print $names
print ''
stats [*:*] [*:*] 'plot.csv' using 1:2 name 'A' nooutput
width = 0.11 * (A_max_x - A_min_x); height = 0.07 * (A_max_y - A_min_y)
array at_x[100]; array at_y[100]; named = 0; behind = 0
covers(k, x, y) = abs(x - at_x[k]) < width && abs(y - at_y[k]) < height
is_free(x, y) = named == 0 || (sum [k=1:named] covers(k, x, y)) == 0
do for [i=1:|$contours|] {
  line = $contours[i]
  behind = words(line) == 3 ? behind + 1 : 0
  if (behind > 8 && named < 100 && is_free(word(line, 1) + 0, word(line, 2) + 0)) {
    named = named + 1; at_x[named] = word(line, 1) + 0; at_y[named] = word(line, 2) + 0; behind = -1e9
    print word(line, 1).','.word(line, 2).','.word(line, 3)
  }
}
unset print
set style textbox opaque noborder margins 0.5, 0.5
)";
}
/// White in black, with the value of each.
constexpr const char* contour_lines =
    ", \\\n  $lines using 1:2 with lines lc rgb 'black' lw 2.5 dt solid notitle"
    ", \\\n  $lines using 1:2 with lines lc rgb 'white' lw 1 dt solid notitle"
    ", \\\n  $names using 1:2:(gprintf('{/*0.8 %.3g}', $3)) with labels boxed notitle";

/// Else the outermost points would be cut.
constexpr const char* room_for_points = "set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03\n";

/// None where all is the same but for rounding.
std::string contours(const std::string& data, Index count) {
  return "lined = high - low > 1e-9 * size\nif (lined) {\n" + contour_table(data, count) + "}\n";
}

}  // namespace

std::string surface(const study::Design& design, const Columns& columns, const SweepFigure& figure,
                    const scene::Figure& options) {
  const auto& column = columns[figure.columns[0]];
  const auto at = place(design, figure.columns[0]);
  const bool lined = options.contours > 0 && is_map(design);
  const auto* style = is_map(design) ? "image" : "points pt 7 ps 0.5 lc palette";
  const auto data = "'plot.csv' using 1:2:" + scaled(at);
  const auto plain = fmt::format("plot {} with {} notitle", data, style);
  const auto plot =
      lined ? fmt::format("if (lined) {{ {}{}\n}} else {{ {} }}", plain, contour_lines, plain) : plain;
  return "unset key\nunset grid\nset cblabel offset 0.5,0\n"
         "set rmargin at screen 0.72\n" +
         value_axis({at}, column.key, column, "cb") + (options.logarithmic ? logarithmic_colours() : "") +
         (lined ? contours(data, options.contours) : "") + (is_map(design) ? "" : room_for_points) +
         on_all_terminals(figure.file, unless_empty(plot, "2"), one_column) + "unset offsets\n";
}

}  // namespace mariotte::report
