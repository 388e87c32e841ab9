#include "mariotte/report/figure/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/table/phases.hpp"

namespace mariotte::report {
namespace {

using Rows = std::vector<std::vector<double>>;

constexpr std::size_t most_curves = 100;
constexpr std::size_t most_named = 12;  // more curves share a colour bar instead of a legend
constexpr double invisible = 1e-4;      // of the height of a figure

// At most `most_curves` positions among `count`: the first and every so many after it, since uneven steps
// would look like gaps in a wave.
std::vector<std::size_t> chosen(std::size_t count) {
  const std::size_t step = (count + most_curves - 1) / most_curves;
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < count; i += step) positions.push_back(i);
  return positions;
}

std::size_t columns_of(const Rows& rows) {
  return rows.empty() ? 0 : rows.front().size();
}

std::vector<double> extremes(const Rows& rows) {
  std::vector<double> values;
  for (const auto& row : rows) {
    const auto [least, most] = std::minmax_element(row.begin(), row.end());
    if (least != row.end()) values.insert(values.end(), {*least, *most});
  }
  return values;
}

// One curve; points that differ too little from the last one kept are left out.
std::string block(const std::vector<double>& time, const Rows& rows, std::size_t column, double resolution) {
  std::string text;
  double kept = 0;
  const auto differs = [&](std::size_t i) { return std::abs(rows[i][column] - kept) > resolution; };
  for (std::size_t i = 0; i < time.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == time.size();
    if (!at_end && !differs(i) && !differs(i + 1)) continue;
    kept = rows[i][column];
    text += fmt::format("{},{:.9g},{:.9g}\n", column + 1, time[i], kept);
  }
  return text + "\n\n";
}

std::string blocks(const std::vector<double>& time, const Rows& rows) {
  double greatest = 0;
  for (const double value : extremes(rows)) greatest = std::max(greatest, std::abs(value));
  std::string text;
  for (const std::size_t column : chosen(columns_of(rows)))
    text += block(time, rows, column, invisible * greatest);
  return text;
}

double largest(const std::vector<double>& row) {
  return row.empty() ? 0 : *std::max_element(row.begin(), row.end());
}

struct Figure {
  std::string name;                     // of the file, without its ending
  std::string title;                    // after the scene's
  std::string quantity;                 // along the vertical axis
  std::string thing;                    // what one curve belongs to
  Display display;                      // of the quantity
  std::size_t count;                    // balls or contacts of the chain
  std::size_t block;                    // of the first curve in plot.csv, from 0
  std::vector<std::string> names = {};  // of the curves; if empty, thing and number
};

bool has_legend(const Figure& figure) {
  return figure.count <= most_named;
}

/// The names of the curves as a list of gnuplot's, which `curves` takes titles from.
std::string name_list(const Figure& figure) {
  std::string list;
  for (const auto& name : figure.names) list += (list.empty() ? "" : ", ") + quoted(name);
  return list.empty() ? "" : fmt::format("array name[{}] = [{}]\n", figure.names.size(), list);
}

// One command per curve if they are named; else one for all, so that the data are read once.
std::string curves(const Figure& figure, const Display& time) {
  const std::string scaled = fmt::format("using ({:g}*$2):({:g}*$3)", time.factor, figure.display.factor);
  if (has_legend(figure))
    return fmt::format(
        "plot for [i=1:{}] 'plot.csv' index {}+i-1 {} with lines lw 2 lc palette cb i title {}\n",
        figure.count, figure.block, scaled,
        figure.names.empty() ? fmt::format("sprintf('{} %d', i)", figure.thing) : "name[i] noenhanced");
  return fmt::format("plot 'plot.csv' index {}:{} {}:1 with lines lw 2 lc palette notitle\n", figure.block,
                     figure.block + chosen(figure.count).size() - 1, scaled);
}

std::string figure_script(const Figure& figure, const Display& time, const std::string& title) {
  std::string text = fmt::format("\nset title {} noenhanced\n",
                                 quoted(title.empty() ? figure.title : title + ": " + figure.title));
  text += fmt::format("set ylabel '{} [{}]'\n", figure.quantity, figure.display.unit);
  if (has_legend(figure)) text += name_list(figure);
  text += fmt::format("set cbrange [1:{}]\n", std::max<std::size_t>(2, figure.count));
  text += has_legend(figure) ? "unset colorbox\n"
                             : fmt::format("unset key\nset colorbox\nset cblabel '{}'\n", figure.thing);
  return text + on_both_terminals(figure.name, curves(figure, time));
}

}  // namespace

const std::vector<std::string>& figure_names() {
  static const std::vector<std::string> names = {"forces.png", "forces.svg", "velocities.png",
                                                 "velocities.svg"};
  return names;
}

std::string plot_data(const impact::Trace& trace) {
  const std::string& unit = trace.velocity_unit;
  return fmt::format("# {}, time [s], velocity [{}]\n", trace.moving, unit.empty() ? "SI" : unit) +
         blocks(trace.time, trace.velocity) + "# contact, time [s], force [N]\n" +
         blocks(trace.time, trace.force);
}

// Faint late contacts can last a hundred times longer than the impact, and so can a fall before it; a figure
// that showed them would show nothing else. So the axis ends soon after the last force that could be seen, at
// the latest with the trace, and begins soon before the first if a flight before it is as long as the action.
Window window_of_action(const impact::Trace& trace) {
  constexpr double visible = 1e-3;
  double peak = 0;
  for (const auto& row : trace.force) peak = std::max(peak, largest(row));
  double first = infinity, last = 0;
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    if (!(largest(trace.force[i]) > visible * peak)) continue;
    first = std::min(first, trace.time[i > 0 ? i - 1 : 0]);  // the force begins after that
    last = trace.time[i];
  }
  if (last == 0) return {0, trace.time.back()};
  const double action = last - first;
  if (first < action) return {0, std::min(1.1 * last, trace.time.back())};
  return {first - 0.1 * action, std::min(last + 0.1 * action, trace.time.back())};
}

std::string plot_script(const impact::ContactImpact& impact, const std::string& title,
                        const CurveNames& names) {
  const auto& trace = impact.trace;
  const auto [start, end] = window_of_action(trace);
  const auto time = display_for(std::vector{end}, "s");
  const std::size_t balls = columns_of(trace.velocity);
  const std::size_t contacts = columns_of(trace.force);
  const Figure forces = {.name = "forces",
                         .title = "contact forces",
                         .quantity = "force",
                         .thing = "contact",
                         .display = display_for(extremes(trace.force), "N"),
                         .count = contacts,
                         .block = chosen(balls).size(),
                         .names = names.contacts};
  const Figure velocities = {.name = "velocities",
                             .title = "velocities",
                             .quantity = "velocity",
                             .thing = trace.moving,
                             .display = display_for(extremes(trace.velocity), trace.velocity_unit),
                             .count = balls,
                             .block = 0,
                             .names = names.velocities};
  std::string text = script_head + time_axis(time, start, end) + phase_marks(impact.events, time, end);
  return text + figure_script(forces, time, title) + figure_script(velocities, time, title);
}

}  // namespace mariotte::report
