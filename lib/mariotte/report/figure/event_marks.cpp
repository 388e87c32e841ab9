#include "mariotte/report/figure/event_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mariotte/report/figure/event_words.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_marks = 24;                            // more would hide the curves; ticks do not
constexpr std::array shades = {"#f1f4f8", "#e6ecf3", "#dce4ee"};  // of one, two, three and more contacts

struct Axis {
  const Display& time;
  const Window& window;
  double width;

  double place(double instant) const { return (instant - window.start) / (window.end - window.start); }
  /// The last sample may be rounded to just before the event that ends the run.
  bool shows(double instant) const {
    constexpr double rounding = 1e-9;
    return place(instant) >= -rounding && place(instant) <= 1 + rounding;
  }
};

std::string shade(const Axis& axis, double from, double to, std::size_t closed) {
  from = std::max(from, axis.window.start);
  to = std::min(to, axis.window.end);
  if (closed == 0 || !(axis.place(to) - axis.place(from) > 1 / axis.width)) return "";
  return fmt::format(
      "set object rectangle from {:.8g}, graph 0 to {:.8g}, graph 1 behind fillcolor rgb '{}' "
      "fillstyle solid noborder\n",
      axis.time.factor * from, axis.time.factor * to, shades[std::min(closed, shades.size()) - 1]);
}

std::string shades_of(const Axis& axis, const std::vector<impact::Event>& events) {
  std::string text;
  std::size_t closed = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    closed += events[i].close.size() - events[i].open.size();
    text += shade(axis, events[i].time, i + 1 < events.size() ? events[i + 1].time : axis.window.end, closed);
  }
  return text;
}

/// Lines, or ticks that are a pixel apart at least.
std::string lines(const Axis& axis, const std::vector<impact::Event>& shown, bool across) {
  std::string text;
  double last = -1;
  for (const auto& event : shown) {
    if (axis.place(event.time) - last < 1 / axis.width) continue;
    last = axis.place(event.time);
    text += fmt::format(
        "set arrow from {0:.8g}, graph {1} to {0:.8g}, graph {2} nohead {3} linecolor rgb '#9aa5b1'\n",
        axis.time.factor * event.time, across ? 0 : 1, across ? 1 : 1.025,
        across ? "back dt (3,3) lw 1" : "front lw 1");
  }
  return text;
}

std::vector<impact::Event> shown_by(const Axis& axis, const std::vector<impact::Event>& events) {
  std::vector<impact::Event> shown;
  std::copy_if(events.begin(), events.end(), std::back_inserter(shown),
               [&](const auto& event) { return axis.shows(event.time); });
  return shown;
}

}  // namespace

std::string event_marks(const std::vector<impact::Event>& events, const Display& time, const Window& window,
                        double width, std::optional<double> room) {
  const Axis axis{time, window, width};
  const auto shown = shown_by(axis, events);
  if (shown.size() > most_marks) return lines(axis, shown, false);
  return shades_of(axis, events) + lines(axis, shown, true) +
         (room ? event_words(shown, window, width, *room) : "");
}

std::string event_ticks(const std::vector<impact::Event>& events, const Display& time, const Window& window,
                        double width) {
  const Axis axis{time, window, width};
  return lines(axis, shown_by(axis, events), false);
}

}  // namespace mariotte::report
