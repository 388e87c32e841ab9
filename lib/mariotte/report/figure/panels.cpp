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
constexpr double top = 0.82;                      // part of the sheet
constexpr double name_of_time = 0.05, name_of_origin = 0.11, name_of_values = 0.036;
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

struct Ticks {
  double step, first, last;
  bool are_two() const { return first + step <= last * (1 + 1e-12); }
};

/// Those of a panel of `width` pixels. Beside others no number may reach over to theirs; where there is no
/// room for two at even steps, two near the ends say how long the panel is.
Ticks ticks(double start, double end, double width, bool has_others) {
  const auto inset = [&](double step) {
    const double half = 0.5 * (pixels_of_tick(end, step) - room_of_tick);
    return has_others ? std::max(0.0, half - 0.25 * between) * (end - start) / width : 0;
  };
  const auto at_steps = [&](double step) -> Ticks {
    return {step, step * std::ceil((start + inset(step)) / step),
            step * std::floor((end - inset(step)) / step)};
  };
  const auto even = at_steps(step_between(start, end, width));
  if (even.are_two()) return even;
  double step = even.step;
  for (int finer = 0; finer < 3; ++finer) {
    step = tick_step(0.3 * step, 1);
    const auto [_, first, last] = at_steps(step);
    const double apart = width * (last - first) / (end - start);
    if (last > first && apart > pixels_of_tick(end, step)) return {last - first, first, last};
  }
  return even;
}

/// How the time axis of each panel has its numbers.
class Numbers {
 public:
  Numbers(const TimeAxis& axis, const std::vector<Panel>& panels)
      : axis_(axis), has_others_(panels.size() > 1), has_symbols_(has_room_for_symbols(panels)) {
    double longest = 0;
    for (const auto& panel : panels) {
      is_relative_ |= has_others_ && !ticks_of(panel).are_two();
      longest = std::max(longest, panel.window.end - panel.window.start);
    }
    since_ = display_for(std::vector{longest}, "s");
  }
  double bottom() const { return is_relative_ ? 0.235 : 0.19; }
  std::string name() const {
    return is_relative_ ? fmt::format("time t − t_0 [{}]", since_.unit)
                        : fmt::format("time t [{}]", axis_.display.unit);
  }
  std::string commands(const Panel& panel) const {
    if (is_relative_) return relative(panel);
    const auto [step, first, last] = ticks_of(panel);
    const auto range =
        fmt::format("set xrange [{:.10g}:{:.10g}]\n", shown(panel.window.start), shown(panel.window.end));
    return range + (has_others_ ? fmt::format("set xtics {:.10g},{:.10g},{:.10g}\n", first, step, last)
                                : fmt::format("set xtics {:g}\n", step));
  }

 private:
  static constexpr double small = 0.8;  // of the usual letters

  double shown(double time) const { return axis_.display.factor * time; }
  static double width(const Panel& panel) { return (panel.right - panel.left) * one_column.width; }
  Ticks ticks_of(const Panel& panel) const {
    return ticks(shown(panel.window.start), shown(panel.window.end), width(panel), has_others_);
  }
  /// The first event that the panel shows, or its start.
  double origin(const Window& window) const {
    for (const auto& event : axis_.events)
      if (event.time >= window.start && event.time <= window.end) return event.time;
    return window.start;
  }
  /// Numbers that count from an instant, which stands below them: of the times themselves all digits would be
  /// the same but for the last.
  std::string relative(const Panel& panel) const {
    const double t0 = origin(panel.window), start = since_.factor * (panel.window.start - t0),
                 end = since_.factor * (panel.window.end - t0);
    const bool is_long = end >= 100;  // so that the last number may reach over to those of others
    const auto [step, _, last] = ticks(start, end, width(panel), is_long);
    std::string list;
    for (double at = step * std::ceil(start / step); at <= last * (1 + 1e-12); at += step)
      list += fmt::format("{}'{}' {:.15g}", list.empty() ? "" : ", ",
                          tick_name(std::abs(at) < 1e-9 * step ? 0 : at), shown(t0 + at / since_.factor));
    return fmt::format(
        "set xrange [{:.15g}:{:.15g}]\nset xtics ({})\nset label '{}' at graph 0.5, screen {} center\n",
        shown(panel.window.start), shown(panel.window.end), list, origin_text(t0), name_of_origin);
  }
  /// Small, and without its symbol where panels are narrow.
  std::string origin_text(double t0) const {
    const auto display = display_for(std::vector{t0}, "s");
    return fmt::format("{{/*{} {}{:.6g} {}}}", small, has_symbols_ ? "t_0 = " : "", display.factor * t0,
                       display.unit);
  }
  bool has_room_for_symbols(const std::vector<Panel>& panels) const {
    constexpr std::size_t longest = sizeof("t_0 = 123.456 ms");
    return std::all_of(panels.begin(), panels.end(), [](const Panel& panel) {
      return small * letter_width * longest < width(panel) + between;
    });
  }

  const TimeAxis& axis_;
  bool has_others_, has_symbols_, is_relative_ = false;
  Display since_{};
};

std::string edges(const Panel& panel) {
  return fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", panel.left, panel.right);
}

/// Title, and the name of the time axis below the middle of all panels.
std::string words_of_sheet(const Title& title, const std::string& name, const std::vector<Panel>& panels) {
  return fmt::format(
      "set label {} at screen 0.5, 0.96 center noenhanced\nset label '{}' at screen {:.4f}, {} center\n",
      title.text, name, 0.5 * (panels.front().left + panels.back().right), name_of_time);
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
  const Numbers numbers(axis, panels);
  std::string plot = "set multiplot\n";
  for (const auto& panel : panels) {
    plot += panel.is_first ? "set border 3\nset ytics nomirror out\n" +
                                 words_of_sheet(head, numbers.name() + axis.note, panels)
                           : "set border 1\nunset ytics\n";
    plot += edges(panel) + numbers.commands(panel);
    plot += inside(panel) + "unset label\nunset arrow\nunset object\n";
  }
  return fmt::format("\nset tmargin at screen {}\nset bmargin at screen {}\n", below_head, numbers.bottom()) +
         on_all_terminals(file, plot + "unset multiplot\n", one_column);
}

}  // namespace mariotte::report
