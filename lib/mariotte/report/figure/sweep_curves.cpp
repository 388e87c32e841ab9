#include <fmt/format.h>

#include "mariotte/report/figure/drawn_axes.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/line_names.hpp"
#include "mariotte/report/figure/sweep_axes.hpp"
#include "mariotte/report/figure/sweep_figure.hpp"
#include "mariotte/report/figure/value_axis.hpp"

namespace mariotte::report {
namespace {

constexpr Index few_points = 40;  // that marks do not hide the curve

/// What gnuplot draws of which rows, and what its key calls it.
struct Line {
  std::string condition, height, title;
};

std::vector<Line> lines(const study::Design& design, const Columns& columns, const SweepFigure& figure) {
  std::vector<Line> all;
  if (!is_family(design)) {
    for (const auto column : figure.columns)
      all.push_back({"", scaled(place(design, column)), short_label(columns[column])});
    return all;
  }
  const auto height = scaled(place(design, figure.columns[0]));
  for (const auto& name : value_names(design.parameters[drawn_parameters(design)[1]]))
    all.push_back({fmt::format("$2 == {} && ", all.size()), height, name});
  return all;
}

/// Points of one line lie apart in plot.csv, so many rows from each other, where those between them are of
/// other lines.
std::size_t rows_apart(const study::Design& design) {
  const auto drawn = drawn_parameters(design);
  const bool mixed = is_family(design) && design.parameters[drawn[0]].axis < design.parameters[drawn[1]].axis;
  return mixed ? design.parameters[drawn[1]].list.size() : 1;
}

/// A point between two jumps has no line; marks as wide as a line that is not dashed show it.
std::string style(const study::Design& design, bool is_dashed) {
  const auto& one = design.parameters[drawn_parameters(design)[0]];
  if (!is_curve(one)) return one.range ? "with points ps 0.4" : "with points";
  if (design.axes[static_cast<std::size_t>(one.axis)].count <= few_points) return "with linespoints";
  return is_dashed ? "with lines" : "with linespoints pt 7 ps 0.2";
}

/// What changes where the numbers may jump: how the run ended, and columns that count, as impacts.count.
std::string state(const study::Design& design, const Columns& columns) {
  auto text = fmt::format("strcol({})", place(design, columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].key.ends_with(".count")) text += fmt::format(".','.strcol({})", place(design, k));
  return text;
}

/// What a figure begins with. gnuplot numbers the stretches without a jump along a line.
constexpr const char* beginning =
    "unset key\nunset arrow\nset rmargin\nunset colorbox\n"
    "stretch(state) = (state eq last ? 0 : (last = state, count = count + 1), count)\n";

/// Every other stretch of line `k`, from the first or the second on: no line crosses a jump.
std::string half(const study::Design& design, const Columns& columns, const Line& line, std::size_t k,
                 int parity) {
  const auto apart = rows_apart(design);
  return fmt::format(
      "last = '', count = 0, 'plot.csv'{} using 1:({}stretch({}) % 2 == {} ? {} : NaN) {} lt {} {}",
      apart > 1 ? fmt::format(" every {}::{}", apart, k) : "", line.condition, state(design, columns), parity,
      line.height, style(design, k > 0), k + 1, parity ? "title " + quoted(line.title) : "notitle");
}

/// What the names of a family are values of.
std::string heading(const study::Design& design) {
  return is_family(design) ? axis_name(design.parameters[drawn_parameters(design)[1]]) : "";
}

std::vector<NamedLine> named(const std::vector<Line>& lines) {
  std::vector<NamedLine> all;
  for (const auto& [condition, height, title] : lines)
    all.push_back({"'plot.csv'", "$1", fmt::format("({}1 ? {} : NaN)", condition, height), title});
  return all;
}

/// Commands for the names, and the sheet that has room for them.
std::pair<std::string, Sheet> naming(const std::vector<NamedLine>& lines, const std::string& heading) {
  if (lines.size() == 1) return {"", one_column};
  if (fit_beside(lines, heading)) return {names_beside(lines, heading), one_column};
  return {names_below(heading), sheet_with_names(lines.size())};
}

}  // namespace

std::string curves(const study::Design& design, const Columns& columns, const SweepFigure& figure) {
  const auto all = lines(design, columns, figure);
  std::vector<std::string> draw;
  for (std::size_t k = 0; k < all.size(); ++k)
    for (const int parity : {1, 0}) draw.push_back(half(design, columns, all[k], k, parity));
  std::vector<std::size_t> places;
  for (const auto column : figure.columns) places.push_back(place(design, column));
  const auto& column = columns[figure.columns[0]];
  const auto [names, sheet] = naming(named(all), heading(design));
  return beginning + value_axis(places, figure.columns.size() > 1 ? figure.key : column.key, column, "y") +
         names +
         on_all_terminals(figure.file,
                          unless_empty(fmt::format("plot {}", fmt::join(draw, ", \\\n  ")), "(0)"), sheet);
}

}  // namespace mariotte::report
