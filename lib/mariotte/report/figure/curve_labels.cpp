#include "mariotte/report/figure/curve_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/label_places.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_joint_names = 3;  // of curves that coincide
constexpr std::size_t most_pulses = 4;       // of a curve that leave room for names above peaks
constexpr double label_height = 0.072;       // of a panel
constexpr double label_gap = 14;             // pixels from the end of a curve to its name

/// How often a curve rises from zero.
std::size_t pulses(const Curve& curve, double height) {
  std::size_t count = 0;
  bool was_flat = true;
  for (const double value : curve.value) {
    const bool is_flat = std::abs(value) < invisible * height;
    count += was_flat && !is_flat;
    was_flat = is_flat;
  }
  return count;
}

/// Names of a group, one per line or all in one.
std::vector<std::string> names(const TimeFigure& figure, const Group& group) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < std::min(group.size(), most_joint_names); ++k)
    all.push_back(figure.curves[group[k]].name);
  if (group.size() > most_joint_names)
    all.back() = fmt::format("and {} more", group.size() - most_joint_names + 1);
  return all;
}

std::string joint_name(const TimeFigure& figure, const Group& group) {
  return fmt::format("{}", fmt::join(names(figure, group), ", "));
}

/// The same without what stands in parentheses.
std::string symbols(const TimeFigure& figure, const Group& group) {
  auto all = names(figure, group);
  for (auto& name : all) name = name.substr(0, name.find(" ("));
  return fmt::format("{}", fmt::join(all, ", "));
}

double pixels(const std::string& words) {
  return letter_width * (static_cast<double>(letters(words)) + 0.5);
}

/// A label of a group's colour.
std::string label(const std::string& text, double x, double y, const char* side, std::size_t line) {
  return fmt::format("set label {} at graph {:.4f}, graph {:.4f} {} front textcolor lt {}\n", quoted(text), x,
                     y, side, line + 1);
}

/// From a curve to its name: thin and grey, unlike data.
std::string leader(double x, double y, double to_x, double to_y) {
  return fmt::format(
      "set arrow from graph {:.4f}, graph {:.4f} to graph {:.4f}, graph {:.4f} nohead lc rgb '#9aa5b1' lw "
      "0.7 "
      "dt solid\n",
      x, y, to_x, to_y);
}

/// To the nearest place of the edge of a name that faces the curve.
std::string leader_to(const Box& box, double x, double y) {
  const double inset = std::min(0.02, 0.5 * box.width);
  const double to = std::clamp(x, box.x + inset, box.x + box.width - inset);
  return leader(x, y, to, box.y + 0.5 * box.height > y ? box.y : box.y + box.height);
}

double value_at(const TimeFigure& figure, const Curve& curve, double time) {
  const auto next = std::lower_bound(figure.time.begin(), figure.time.end(), time);
  const auto i = static_cast<std::size_t>(next - figure.time.begin());
  if (i == 0 || i == figure.time.size()) return curve.value[i == 0 ? 0 : i - 1];
  const double part = (time - figure.time[i - 1]) / (figure.time[i] - figure.time[i - 1]);
  return curve.value[i - 1] + part * (curve.value[i] - curve.value[i - 1]);
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

/// What the curves cover of a panel, in steps.
std::vector<Box> covered(const TimeFigure& figure, const std::vector<Group>& groups, const Range& range,
                         const Window& window) {
  constexpr int steps = 150;
  std::vector<Box> all;
  for (const auto& group : groups) {
    const auto height = [&](int step) {
      const double time = window.start + (window.end - window.start) * step / steps;
      return range.place(value_at(figure, figure.curves[group.front()], time));
    };
    for (int step = 0; step < steps; ++step) {
      const auto [low, high] = std::minmax({height(step), height(step + 1)});
      all.push_back({1.0 * step / steps, low, 1.0 / steps, high - low + 1e-9});
    }
  }
  return all;
}

}  // namespace

std::size_t letters(const std::string& text) {
  return width(text) - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
           return c == '{' || c == '}' || c == '_' || c == '@' || c == '^';
         }));
}

double sheet_pixels(const Panel& panel) {
  return (panel.right - panel.left) * one_column.width;
}

Naming naming(const TimeFigure& figure, const std::vector<Group>& groups, const Range& range,
              double narrowest) {
  std::vector<std::size_t> count;
  for (const auto& group : groups)
    count.push_back(pulses(figure.curves[group.front()], range.most - range.least));
  const bool have_room = std::none_of(count.begin(), count.end(), [](auto n) { return n > most_pulses; });
  const auto has_peak = [&](std::size_t k) {
    return figure.names == Names::at_peak && have_room && count[k] > 0;
  };
  bool all_fit = true;
  for (std::size_t k = 0; k < groups.size(); ++k)
    all_fit &= !has_peak(k) || pixels(joint_name(figure, groups[k])) <= narrowest;
  Naming all;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (has_peak(k)) all.at_peak.push_back(k);
    if (!has_peak(k) || !all_fit) all.at_end.push_back(k);
  }
  return all;
}

std::string end_labels(const TimeFigure& figure, const std::vector<Group>& groups,
                       const std::vector<std::size_t>& named, const Range& range, const Panel& panel) {
  std::vector<double> wanted, space;
  for (const auto k : named) {
    const auto& curve = figure.curves[groups[k].front()];
    wanted.push_back(range.place(value_at(figure, curve, panel.window.end)));
    space.push_back(label_height * static_cast<double>(names(figure, groups[k]).size()));
  }
  const auto place = spread(wanted, space);
  const double beside = 1 + label_gap / sheet_pixels(panel);
  std::string text;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const auto lines = names(figure, groups[named[i]]);
    text += leader(1, wanted[i], beside, place[i]);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const double above = 0.5 * static_cast<double>(lines.size() - 1) - static_cast<double>(k);
      text += label(lines[k], beside + 0.01, place[i] + above * label_height, "left", named[i]);
    }
  }
  return text;
}

std::string peak_labels(const TimeFigure& figure, const std::vector<Group>& groups, const Naming& named,
                        const Range& range, const Panel& panel) {
  const auto& window = panel.window;
  const Window whole{figure.time.front(), figure.time.back()};
  const auto curves = covered(figure, groups, range, window);
  std::vector<Box> taken;
  std::string text;
  for (const auto k : named.at_peak) {
    const auto& curve = figure.curves[groups[k].front()];
    const auto at = peak_of(figure, curve, window);
    if (at == figure.time.size() || (!panel.is_first && at != peak_of(figure, curve, whole))) continue;
    if (std::abs(curve.value[at]) < invisible * (range.most - range.least)) continue;
    const bool has_end = std::find(named.at_end.begin(), named.at_end.end(), k) != named.at_end.end();
    const auto words = has_end ? symbols(figure, groups[k]) : joint_name(figure, groups[k]);
    const double length = pixels(words) / sheet_pixels(panel);
    const double x = (figure.time[at] - window.start) / (window.end - window.start);
    const double y = range.place(curve.value[at]) + (curve.value[at] < 0 ? -1.2 * label_height : 0.02);
    const double left = std::clamp(x - 0.5 * length, 0.0, std::max(0.0, 1 - length));
    taken.push_back(free_place({left, y, length, label_height}, taken, curves));
    const auto& box = taken.back();
    if (std::abs(box.y - y) > 0.5 * label_height || std::abs(box.x - left) > 0.3 * length)
      text += leader_to(box, x, range.place(curve.value[at]));
    text += label(words, box.x + 0.5 * length, box.y + 0.5 * label_height, "center", k);
  }
  return text;
}

double margin_of(const TimeFigure& figure, const std::vector<Group>& groups,
                 const std::vector<std::size_t>& named) {
  std::size_t most = 0;
  for (const auto k : named)
    for (const auto& name : names(figure, groups[k])) most = std::max(most, letters(name));
  return most == 0 ? 26 : label_gap + 8 + letter_width * static_cast<double>(most);
}

}  // namespace mariotte::report
