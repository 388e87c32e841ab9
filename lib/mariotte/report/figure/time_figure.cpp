#include "mariotte/report/figure/time_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/figure/event_marks.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/label_places.hpp"

namespace mariotte::report {
namespace {

constexpr double invisible = 0.004;                  // of the height of a figure
constexpr std::size_t most_names = 3;                // of curves that coincide
constexpr double line_height = 0.072, letter = 7.2;  // part of a panel's height, pixels
constexpr double gap = 14;                           // pixels from the end of a curve to its name
constexpr double beyond = 22;                        // pixels that words of events may use right of the axis

using Group = std::vector<std::size_t>;

double sheet_pixels(const Panel& panel) {
  return (panel.right - panel.left) * one_column.width;
}

/// The vertical axis [SI].
struct Range {
  double least = 0;
  double most = 0;

  double place(double value) const { return (value - least) / (most - least); }
};

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

bool is_flat(const Curve& curve, double height) {
  return std::all_of(curve.value.begin(), curve.value.end(),
                     [&](double value) { return std::abs(value) < invisible * height; });
}

/// Names of a group, one per line or all in one.
std::vector<std::string> names(const TimeFigure& figure, const Group& group) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < std::min(group.size(), most_names); ++k)
    all.push_back(figure.curves[group[k]].name);
  if (group.size() > most_names) all.back() = fmt::format("and {} more", group.size() - most_names + 1);
  return all;
}

/// Letters of enhanced text that are seen.
std::size_t letters(const std::string& text) {
  return width(text) - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
           return c == '{' || c == '}' || c == '_';
         }));
}

/// A label of a group's colour; names are the program's own.
std::string label(const std::string& text, double x, double y, const char* side, std::size_t line) {
  return fmt::format("set label '{}' at graph {:.4f}, graph {:.4f} {} front textcolor lt {}\n", text, x, y,
                     side, line + 1);
}

/// From a curve to its name: thin and grey, unlike data.
std::string leader(double x, double y, double to_x, double to_y) {
  return fmt::format(
      "set arrow from graph {:.4f}, graph {:.4f} to graph {:.4f}, graph {:.4f} nohead lc rgb '#9aa5b1' lw "
      "0.7 "
      "dt solid\n",
      x, y, to_x, to_y);
}

/// Which groups are named beside the right end, and which above a peak.
struct Naming {
  std::vector<std::size_t> at_end, at_peak;
};

Naming naming(const TimeFigure& figure, const std::vector<Group>& groups, const Range& range) {
  Naming all;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const bool peak = figure.names == Names::at_peak &&
                      !is_flat(figure.curves[groups[k].front()], range.most - range.least);
    (peak ? all.at_peak : all.at_end).push_back(k);
  }
  return all;
}

double value_at(const TimeFigure& figure, const Curve& curve, double time) {
  const auto next = std::lower_bound(figure.time.begin(), figure.time.end(), time);
  const auto i = static_cast<std::size_t>(next - figure.time.begin());
  if (i == 0 || i == figure.time.size()) return curve.value[i == 0 ? 0 : i - 1];
  const double part = (time - figure.time[i - 1]) / (figure.time[i] - figure.time[i - 1]);
  return curve.value[i - 1] + part * (curve.value[i] - curve.value[i - 1]);
}

/// Names beside the ends of curves, joined to them by leaders; each has a line of its own, since distances
/// between lines of one label differ among terminals.
std::string end_labels(const TimeFigure& figure, const std::vector<Group>& groups,
                       const std::vector<std::size_t>& named, const Range& range, const Panel& panel) {
  std::vector<double> wanted, space;
  for (const auto k : named) {
    const auto& curve = figure.curves[groups[k].front()];
    wanted.push_back(range.place(value_at(figure, curve, panel.window.end)));
    space.push_back(line_height * static_cast<double>(names(figure, groups[k]).size()));
  }
  const auto place = spread(wanted, space);
  const double beside = 1 + gap / sheet_pixels(panel);
  std::string text;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const auto lines = names(figure, groups[named[i]]);
    text += leader(1, wanted[i], beside, place[i]);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const double above = 0.5 * static_cast<double>(lines.size() - 1) - static_cast<double>(k);
      text += label(lines[k], beside + 0.01, place[i] + above * line_height, "left", named[i]);
    }
  }
  return text;
}

/// Where a curve is farthest from zero within a window: position of the sample.
std::size_t peak_of(const TimeFigure& figure, const Curve& curve, const Window& window) {
  std::size_t most = figure.time.size();
  for (std::size_t i = 0; i < figure.time.size(); ++i)
    if (figure.time[i] >= window.start && figure.time[i] <= window.end &&
        (most == figure.time.size() || std::abs(curve.value[i]) > std::abs(curve.value[most])))
      most = i;
  return most;
}

/// Names above the peaks that lie in this panel, or below those that point down.
std::string peak_labels(const TimeFigure& figure, const std::vector<Group>& groups,
                        const std::vector<std::size_t>& named, const Range& range, const Panel& panel) {
  const auto& window = panel.window;
  const Window whole{figure.time.front(), figure.time.back()};
  std::vector<Box> taken;
  std::string text;
  for (const auto k : named) {
    const auto& curve = figure.curves[groups[k].front()];
    const auto at = peak_of(figure, curve, window);
    if (at == figure.time.size() || (!panel.is_first && at != peak_of(figure, curve, whole))) continue;
    if (std::abs(curve.value[at]) < invisible * (range.most - range.least)) continue;
    const auto words = fmt::format("{}", fmt::join(names(figure, groups[k]), ", "));
    const double wide = letter * (static_cast<double>(letters(words)) + 0.5) / sheet_pixels(panel);
    const double x = (figure.time[at] - window.start) / (window.end - window.start);
    const double y = range.place(curve.value[at]) + (curve.value[at] < 0 ? -1.2 * line_height : 0.02);
    const double left = std::clamp(x - 0.5 * wide, 0.0, std::max(0.0, 1 - wide));
    taken.push_back(free_place({left, y, wide, line_height}, taken));
    const auto& box = taken.back();
    if (std::abs(box.y - y) > 0.5 * line_height)
      text +=
          leader(x, range.place(curve.value[at]), left + 0.5 * wide, box.y > y ? box.y : box.y + line_height);
    text += label(words, left + 0.5 * wide, box.y + 0.5 * line_height, "center", k);
  }
  return text;
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

double margin_of(const TimeFigure& figure, const std::vector<Group>& groups,
                 const std::vector<std::size_t>& named) {
  std::size_t most = 0;
  for (const auto k : named)
    for (const auto& name : names(figure, groups[k])) most = std::max(most, letters(name));
  return most == 0 ? 26 : gap + 8 + letter * static_cast<double>(most);
}

}  // namespace

TimeAxis time_axis(std::vector<Window> windows, std::vector<impact::Event> events,
                   const scene::Figure& figure) {
  if (figure.window) windows = {{(*figure.window)[0], (*figure.window)[1]}};
  return {display_for(std::vector{windows.back().end}, "s"), windows, std::move(events),
          figure.window.has_value()};
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
  const auto groups = coincident(figure);
  const auto range = range_of(figure, axis);
  const auto display = display_for(std::vector{range.least, range.most}, figure.unit);
  const auto named = naming(figure, groups, range);
  const auto inside = [&](const Panel& panel) {
    auto text = fmt::format("set yrange [{:.8g}:{:.8g}]\n", display.factor * range.least,
                            display.factor * range.most);
    if (panel.is_first)
      text += fmt::format("set ylabel '{} [{}]' offset 1.2,0\n", figure.quantity, display.unit);
    text +=
        event_marks(axis.events, axis.display, panel.window, sheet_pixels(panel), panel.is_last ? beyond : 0);
    if (panel.is_last) text += end_labels(figure, groups, named.at_end, range, panel);
    return text + peak_labels(figure, groups, named.at_peak, range, panel) +
           plot(figure, groups, axis, display);
  };
  return on_panels(figure.file, figure.title, axis,
                   panels(axis.windows, margin_of(figure, groups, named.at_end)), inside);
}

}  // namespace mariotte::report
