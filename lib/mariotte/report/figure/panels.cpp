#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/figure/ticks.hpp"
#include "mariotte/report/figure/time_figure.hpp"
#include "mariotte/report/figure/title.hpp"

namespace mariotte::report {
namespace {

constexpr double left_margin = 80, between = 16;  // pixels
constexpr double bottom = 0.19, top = 0.82;       // parts of the sheet
constexpr double name_of_time = 0.05, name_of_values = 0.036;
constexpr double room_of_tick = 14;  // pixels beside a number below the axis
constexpr double least_share = 0.6;  // of the widest panel

/// Pixels between numbers up to `most` at multiples of `step`.
double pixels_of_tick(double most, double step) {
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step))));
  const auto longest = std::max<std::size_t>(4, fmt::format("{:.{}f}", most, decimals).size());
  return letter_width * static_cast<double>(longest) + room_of_tick;
}

/// Of ticks that leave room for their numbers.
double step_between(double start, double end, double width) {
  const double step = tick_step(end - start, width / pixels_of_tick(end, end - start));
  return tick_step(end - start, width / pixels_of_tick(end, step));
}

/// gnuplot's ticks on a panel of `width` pixels. Beside others no number may reach over to theirs. Where
/// there is room for one number only, two near the ends say how long the panel is, or one says where it is.
std::string ticks(double start, double end, double width, bool has_others) {
  const auto inset = [&](double step) {
    const double half = 0.5 * (pixels_of_tick(end, step) - room_of_tick);
    return has_others ? std::max(0.0, half - 0.25 * between) * (end - start) / width : 0;
  };
  const auto first = [&](double step) { return step * std::ceil((start + inset(step)) / step); };
  const auto last = [&](double step) { return step * std::floor((end - inset(step)) / step); };
  const double even = step_between(start, end, width);
  if (first(even) + even <= last(even) * (1 + 1e-12))
    return has_others ? fmt::format("{:.10g},{:g},{:.10g}", first(even), even, last(even))
                      : fmt::format("{:g}", even);
  double step = even;
  for (int finer = 0; finer < 3; ++finer) {
    step = tick_step(0.3 * step, 1);
    const double apart = width * (last(step) - first(step)) / (end - start);
    if (last(step) > first(step) && apart > pixels_of_tick(end, step) - room_of_tick)
      return fmt::format("{:.10g},{:.10g},{:.10g}", first(step), last(step) - first(step), last(step));
  }
  for (step = even; step > 1e-3 * even; step = tick_step(0.3 * step, 1))
    if (first(step) <= last(step)) return fmt::format("{0:.10g},{1:g},{0:.10g}", first(step), step);
  return fmt::format("{:g}", even);
}

/// Numbers below the panels; the first has the numbers beside the vertical axis.
std::string horizontal_axis(const Panel& panel, const TimeAxis& axis, double width) {
  const bool has_others = !panel.is_first || !panel.is_last;
  const double start = axis.display.factor * panel.window.start, end = axis.display.factor * panel.window.end;
  return fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset xrange [{:.10g}:{:.10g}]\n"
      "set xtics {}\n",
      panel.left, panel.right, start, end, ticks(start, end, width, has_others));
}

/// Title, and the name of the time axis below the middle of all panels.
std::string words_of_sheet(const Title& title, const TimeAxis& axis, const std::vector<Panel>& panels) {
  return fmt::format(
      "set label {} at screen 0.5, 0.96 center noenhanced\nset label 'time t [{}]{}' at screen {:.4f}, {} "
      "center\n",
      title.text, axis.display.unit, axis.note, 0.5 * (panels.front().left + panels.back().right),
      name_of_time);
}

}  // namespace

std::vector<Panel> panels(const std::vector<Window>& windows, double margin) {
  std::vector<double> share;
  double longest = 0;
  for (const auto& one : windows) longest = std::max(longest, one.end - one.start);
  double sum = 0;
  for (const auto& one : windows) share.push_back(std::max(one.end - one.start, least_share * longest));
  for (const double one : share) sum += one;
  const double gaps = between * static_cast<double>(windows.size() - 1);
  const double room = one_column.width - left_margin - margin - gaps;
  std::vector<Panel> all;
  double left = left_margin;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double width = sum > 0 ? room * share[i] / sum : room;
    all.push_back({windows[i], left / one_column.width, (left + width) / one_column.width, i == 0,
                   i + 1 == windows.size()});
    left += width + between;
  }
  return all;
}

std::string vertical_name(const std::string& text) {
  return fmt::format("set label {} at screen {}, graph 0.5 center rotate\n", quoted(text), name_of_values);
}

std::string on_panels(const std::string& file, const std::string& title, const TimeAxis& axis,
                      const std::vector<Panel>& panels,
                      const std::function<std::string(const Panel&)>& inside) {
  const auto head = wrapped(title);
  const double below_head = top - static_cast<double>(head.more_height) / one_column.height;
  std::string plot = "set multiplot\n";
  for (const auto& panel : panels) {
    plot += panel.is_first ? "set border 3\nset ytics nomirror out\n" + words_of_sheet(head, axis, panels)
                           : "set border 1\nunset ytics\n";
    plot += horizontal_axis(panel, axis, (panel.right - panel.left) * one_column.width);
    plot += inside(panel) + "unset label\nunset arrow\nunset object\n";
  }
  return fmt::format("\nset tmargin at screen {}\nset bmargin at screen {}\n", below_head, bottom) +
         on_all_terminals(file, plot + "unset multiplot\n", one_column);
}

}  // namespace mariotte::report
