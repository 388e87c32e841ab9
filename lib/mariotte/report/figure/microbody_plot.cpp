#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/plot.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

/// Columns of plot.csv behind the time: three velocities, then three forces per tip.
constexpr int first_velocity = 2, first_force = 5;

std::string data(const impact::BodyTrace& trace) {
  std::string text =
      "# time [s], v1, v2, v3 [m/s], then normal force and friction along e2, e3 of each tip [N]\n";
  for (std::size_t row = 0; row < trace.state.size(); ++row) {
    const auto& v = trace.state[row].velocity;
    append_rounded(trace.state[row].time, 9, text);
    for (const double one : {v.e1, v.e2, v.e3}) append_rounded(one, 9, text += ',');
    for (std::size_t i = 0; i < trace.gap[row].size(); ++i) {
      const auto& friction = trace.friction[row][i];
      for (const double one : {trace.normal_force[row][i], friction.e2, friction.e3})
        append_rounded(one, 9, text += ',');
    }
    text += "\n";
  }
  return text;
}

TimeFigure empty_figure(const impact::BodyTrace& trace, const char* file, const std::string& title,
                        const char* quantity, const char* unit, Names names) {
  TimeFigure figure{file, title, quantity, unit, names, {}, {}};
  for (const auto& state : trace.state) figure.time.push_back(state.time);
  return figure;
}

/// A curve of column `column` of plot.csv, whose values `read` finds in a row of the trace; those along the
/// plane are left out where they are zero throughout.
template <class Read>
void add(TimeFigure& figure, const std::string& name, int column, const Read& read) {
  Curve curve{name, "'plot.csv'", 1, column, {}};
  for (std::size_t row = 0; row < figure.time.size(); ++row) curve.value.push_back(read(row));
  const auto is_zero = [](double value) { return value == 0; };
  if (figure.curves.empty() || !std::all_of(curve.value.begin(), curve.value.end(), is_zero))
    figure.curves.push_back(std::move(curve));
}

TimeFigure forces(const impact::BodyTrace& trace, const std::string& title) {
  auto figure = empty_figure(trace, "forces", title, "force on a tip F", "N", Names::at_peak);
  for (std::size_t i = 0; i < trace.gap.front().size(); ++i) {
    const int column = first_force + 3 * static_cast<int>(i);
    const auto tip = fmt::format("tip {} ", i + 1);
    add(figure, tip + "normal", column, [&](std::size_t row) { return trace.normal_force[row][i]; });
    add(figure, tip + "e_2", column + 1, [&](std::size_t row) { return trace.friction[row][i].e2; });
    add(figure, tip + "e_3", column + 2, [&](std::size_t row) { return trace.friction[row][i].e3; });
  }
  return figure;
}

TimeFigure velocities(const impact::BodyTrace& trace, const std::string& title) {
  auto figure = empty_figure(trace, "velocities", title, "velocity of centre v", "m/s", Names::at_end);
  add(figure, "normal", first_velocity, [&](std::size_t row) { return trace.state[row].velocity.e1; });
  add(figure, "along e_2", first_velocity + 1, [&](std::size_t row) { return trace.state[row].velocity.e2; });
  add(figure, "along e_3", first_velocity + 2, [&](std::size_t row) { return trace.state[row].velocity.e3; });
  return figure;
}

/// Touches and separations, which part the phases that are shaded.
std::vector<impact::Event> contacts(const std::vector<impact::TipEvents>& events) {
  std::vector<impact::Event> list;
  for (const auto& event : events)
    if (!event.open.empty() || !event.close.empty())
      list.push_back({.time = event.time, .open = event.open, .close = event.close});
  return list;
}

}  // namespace

RunPlot plot(const impact::MicrobodyImpact& impact, const std::string& title, const scene::Figure& figure) {
  const auto& trace = impact.trace;
  RunPlot plot{.data = data(trace),
               .script = script_head(),
               .figures = {"forces", "velocities"},
               .axis = time_axis(action_of(trace), contacts(impact.events), figure)};
  plot.script += script(forces(trace, title), plot.axis) + script(velocities(trace, title), plot.axis);
  return plot;
}

}  // namespace mariotte::report
