#include "mariotte/report/figure/time_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mariotte/report/figure/curve_labels.hpp"
#include "mariotte/report/figure/event_marks.hpp"
#include "mariotte/report/figure/gnuplot.hpp"

namespace mariotte::report {
namespace {

constexpr double beyond = 22;  // pixels that words of events may use right of the axis

Range range_of(const TimeFigure& figure, const TimeAxis& axis) {
  double least = 0, most = 0;
  for (const auto& window : axis.windows)
    for (std::size_t i = 0; i < figure.time.size(); ++i)
      if (figure.time[i] >= window.start && figure.time[i] <= window.end)
        for (const auto& curve : figure.curves) {
          least = std::min(least, curve.value[i]);
          most = std::max(most, curve.value[i]);
        }
  if (most == least) return {least - 1, most + 1};
  const double height = most - least;
  const double room = figure.names == Names::at_peak ? 0.12 : 0.04;
  const double below = least < -invisible * height ? room : 0.012;  // what lies on the axis is seen
  return {least - below * height, most + room * height};
}

std::string plot(const TimeFigure& figure, const std::vector<Group>& groups, const TimeAxis& axis,
                 const Display& display) {
  std::string text = "plot ";
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const auto& curve = figure.curves[groups[k].front()];
    text += fmt::format("{}{} using ({:g}*${}):({:g}*${}) with lines lt {} notitle", k > 0 ? ", \\\n  " : "",
                        curve.data, axis.display.factor, curve.time_column, display.factor,
                        curve.value_column, k + 1);
  }
  return text + "\n";
}

/// The samples that these windows show, without curves that are zero there.
TimeFigure within(TimeFigure figure, const std::vector<Window>& windows) {
  const auto time = figure.time;
  const auto keep = [&](std::vector<double>& values) {
    const auto all = std::exchange(values, {});
    for (std::size_t i = 0; i < time.size(); ++i)
      if (std::any_of(windows.begin(), windows.end(),
                      [&](const Window& one) { return time[i] >= one.start && time[i] <= one.end; }))
        values.push_back(all[i]);
  };
  keep(figure.time);
  for (auto& curve : figure.curves) keep(curve.value);
  const auto is_zero = [](const Curve& curve) {
    return std::all_of(curve.value.begin(), curve.value.end(), [](double value) { return value == 0; });
  };
  if (!std::all_of(figure.curves.begin(), figure.curves.end(), is_zero))
    std::erase_if(figure.curves, is_zero);
  return figure;
}

/// Of the panels without names at their end [pixels].
double narrowest(const TimeAxis& axis) {
  double least = infinity;
  for (const auto& panel : panels(axis.windows, margin_of({}, {}, {})))
    least = std::min(least, sheet_pixels(panel));
  return least;
}

std::string drawn(const TimeFigure& figure, const TimeAxis& axis) {
  const auto groups = coincident(figure);
  const auto range = range_of(figure, axis);
  const auto display = display_for(std::vector{range.least, range.most}, figure.unit);
  const auto named = naming(figure, groups, range, narrowest(axis));
  const auto inside = [&](const Panel& panel) {
    auto text = fmt::format("set yrange [{:.8g}:{:.8g}]\n", display.factor * range.least,
                            display.factor * range.most);
    if (panel.is_first) text += vertical_name(fmt::format("{} [{}]", figure.quantity, display.unit));
    text +=
        event_marks(axis.events, axis.display, panel.window, sheet_pixels(panel), panel.is_last ? beyond : 0);
    if (panel.is_last) text += end_labels(figure, groups, named.at_end, range, panel);
    return text + peak_labels(figure, groups, named, range, panel) + plot(figure, groups, axis, display);
  };
  return on_panels(figure.file, figure.title, axis,
                   panels(axis.windows, margin_of(figure, groups, named.at_end)), inside);
}

}  // namespace

TimeAxis time_axis(const Action& action, std::vector<impact::Event> events, const scene::Figure& figure) {
  TimeAxis axis{.display = {}, .windows = action.windows, .events = std::move(events)};
  if (figure.window) {
    axis.windows = {{(*figure.window)[0], (*figure.window)[1]}};
    axis.is_chosen = true;
  } else if (!action.strongest.empty()) {
    axis.strongest = action.strongest;
    axis.about_strongest =
        action.strongest.size() == action.impacts
            ? ": where forces are strong"
            : fmt::format(": {} strongest of {} impacts", action.strongest.size(), action.impacts);
  }
  axis.display = display_for(std::vector{axis.windows.back().end}, "s");
  return axis;
}

TimeAxis axis_of_forces(const TimeAxis& axis) {
  if (axis.strongest.empty()) return axis;
  auto own = axis;
  own.windows = axis.strongest;
  own.note = axis.about_strongest;
  own.display = display_for(std::vector{own.windows.back().end}, "s");
  return own;
}

std::vector<Group> coincident(const TimeFigure& figure) {
  double least = 0, most = 0;
  for (const auto& curve : figure.curves)
    for (const double value : curve.value) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  const auto same = [&](const Curve& a, const Curve& b) {
    return std::equal(a.value.begin(), a.value.end(), b.value.begin(),
                      [&](double x, double y) { return std::abs(x - y) <= invisible * (most - least); });
  };
  std::vector<Group> groups;
  for (std::size_t k = 0; k < figure.curves.size(); ++k) {
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return same(figure.curves[group.front()], figure.curves[k]);
    });
    if (found == groups.end())
      groups.push_back({k});
    else
      found->push_back(k);
  }
  return groups;
}

std::string script(const TimeFigure& figure, const TimeAxis& axis) {
  if (figure.names == Names::at_peak && !axis.strongest.empty())
    return drawn(within(figure, axis.strongest), axis_of_forces(axis));
  return drawn(figure, axis);
}

}  // namespace mariotte::report
