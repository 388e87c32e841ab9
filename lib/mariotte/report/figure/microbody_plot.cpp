#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/plot.hpp"
#include "mariotte/report/table/phases.hpp"

namespace mariotte::report {
namespace {

/// Columns of plot.csv behind the time: three velocities, then three forces per tip.
constexpr int first_velocity = 2, first_force = 5;

struct Curve {
  int column;
  std::string name;
};

struct Figure {
  std::string name, title, quantity;
  Display display;
  std::vector<Curve> curves;
};

std::string figure(const Figure& figure, const Display& time, const std::string& title) {
  std::string curves;
  for (const auto& curve : figure.curves)
    curves += fmt::format("{}'plot.csv' using ({:g}*$1):({:g}*${}) with lines lw 2 title '{}'",
                          curves.empty() ? "plot " : ", ", time.factor, figure.display.factor, curve.column,
                          curve.name);
  const std::string heading = title.empty() ? figure.title : title + ": " + figure.title;
  return fmt::format("\nset title {} noenhanced\nset ylabel '{} [{}]'\n", quoted(heading), figure.quantity,
                     figure.display.unit) +
         on_both_terminals(figure.name, curves + "\n");
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

std::string plot_data(const impact::BodyTrace& trace) {
  std::string text =
      "# time [s], v1, v2, v3 [m/s], then normal force and friction along e2, e3 of each tip [N]\n";
  for (std::size_t row = 0; row < trace.state.size(); ++row) {
    const auto& v = trace.state[row].velocity;
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}", trace.state[row].time, v.e1, v.e2, v.e3);
    for (std::size_t i = 0; i < trace.gap[row].size(); ++i)
      text += fmt::format(",{:.9g},{:.9g},{:.9g}", trace.normal_force[row][i], trace.friction[row][i].e2,
                          trace.friction[row][i].e3);
    text += "\n";
  }
  return text;
}

std::string plot_script(const impact::MicrobodyImpact& impact, const std::string& title) {
  const auto& trace = impact.trace;
  const double end = trace.state.back().time;
  const auto time = display_for(std::vector{end}, "s");
  std::vector<double> velocities, forces;
  for (std::size_t row = 0; row < trace.state.size(); ++row) {
    const auto& v = trace.state[row].velocity;
    velocities.insert(velocities.end(), {v.e1, v.e2, v.e3});
    forces.insert(forces.end(), trace.normal_force[row].begin(), trace.normal_force[row].end());
  }
  Figure force{.name = "forces",
               .title = "forces on the tips",
               .quantity = "force",
               .display = display_for(forces, "N"),
               .curves = {}};
  for (std::size_t i = 0; i < trace.gap.front().size(); ++i) {
    const int column = first_force + 3 * static_cast<int>(i);
    force.curves.push_back({column, fmt::format("tip {} normal", i + 1)});
    force.curves.push_back({column + 1, fmt::format("tip {} along e2", i + 1)});
    force.curves.push_back({column + 2, fmt::format("tip {} along e3", i + 1)});
  }
  const Figure velocity{
      .name = "velocities",
      .title = "velocity of the mass centre",
      .quantity = "velocity",
      .display = display_for(velocities, "m/s"),
      .curves = {
          {first_velocity, "normal"}, {first_velocity + 1, "along e2"}, {first_velocity + 2, "along e3"}}};
  return script_head + time_axis(time, 0, end) + phase_marks(contacts(impact.events), time, end) +
         figure(force, time, title) + figure(velocity, time, title);
}

}  // namespace mariotte::report
