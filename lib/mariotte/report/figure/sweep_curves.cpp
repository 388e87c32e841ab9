#include <fmt/format.h>

#include "mariotte/report/figure/drawn_axes.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/sweep_axes.hpp"
#include "mariotte/report/figure/sweep_figure.hpp"
#include "mariotte/report/figure/value_axis.hpp"

namespace mariotte::report {
namespace {

constexpr Index few_points = 40;  // that marks do not hide the curve

/// What gnuplot draws, and what its key calls it.
struct Line {
  std::string height, title;
};

std::vector<Line> lines(const study::Design& design, const Columns& columns, const SweepFigure& figure) {
  std::vector<Line> all;
  if (!is_family(design)) {
    for (const auto column : figure.columns)
      all.push_back({scaled(place(design, column)), short_label(columns[column])});
    return all;
  }
  const auto height = scaled(place(design, figure.columns[0]));
  for (const auto& name : value_names(design.parameters[drawn_parameters(design)[1]]))
    all.push_back({fmt::format("($2 == {} ? {} : NaN)", all.size(), height), name});
  return all;
}

/// Lines whose points follow each other in plot.csv, those between them being of other lines; gnuplot puts
/// the others in order.
bool are_apart(const study::Design& design) {
  const auto drawn = drawn_parameters(design);
  return is_family(design) && design.parameters[drawn[0]].axis < design.parameters[drawn[1]].axis;
}

std::string style(const study::Design& design) {
  const auto& one = design.parameters[drawn_parameters(design)[0]];
  if (!is_curve(one)) return one.range ? "with points ps 0.4" : "with points";
  const auto count = design.axes[static_cast<std::size_t>(one.axis)].count;
  return fmt::format("{}with {}", are_apart(design) ? "smooth unique " : "",
                     count <= few_points ? "linespoints" : "lines");
}

std::string key(const study::Design& design, bool several) {
  if (!several) return "unset key\n";
  const auto drawn = drawn_parameters(design);
  const auto title = is_family(design) ? quoted(axis_name(design.parameters[drawn[1]])) : "''";
  return fmt::format("set key outside right top vertical title {}\n", title);
}

}  // namespace

std::string curves(const study::Design& design, const Columns& columns, const SweepFigure& figure) {
  std::vector<std::string> draw;
  for (const auto& [height, title] : lines(design, columns, figure))
    draw.push_back(fmt::format("'plot.csv' using 1:{} {} lt {} title {}", height, style(design),
                               draw.size() + 1, quoted(title)));
  std::vector<std::size_t> places;
  for (const auto column : figure.columns) places.push_back(place(design, column));
  const bool several = draw.size() > 1;
  const auto& column = columns[figure.columns[0]];
  return key(design, several) + "unset colorbox\n" +
         value_axis(places, figure.columns.size() > 1 ? figure.key : column.key, column, "y") +
         on_all_terminals(file_name(figure),
                          unless_empty(fmt::format("plot {}", fmt::join(draw, ", \\\n  ")), "(0)"),
                          several ? wide : one_column);
}

}  // namespace mariotte::report
