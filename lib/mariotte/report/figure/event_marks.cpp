#include "mariotte/report/figure/event_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/figure/label_places.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_lines = 24;  // more would hide the curves; ticks do not
constexpr double pixels_of_letter = 5.2;
constexpr int rows = 2;
constexpr std::array shades = {"#f1f4f8", "#e6ecf3", "#dce4ee"};  // of one, two, three and more contacts

struct Axis {
  const Display& time;
  const Window& window;
  double width;

  double place(double instant) const { return (instant - window.start) / (window.end - window.start); }
  bool shows(double instant) const { return instant >= window.start && instant <= window.end; }
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
std::string lines(const Axis& axis, const std::vector<impact::Event>& shown) {
  const bool across = shown.size() <= most_lines;
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

/// "1–2 close"
struct Change {
  const char* verb;
  std::vector<Index> contacts;
};

std::vector<Change> changes(const impact::Event& event) {
  std::vector<Change> all = {
      {"close", event.close}, {"open", event.open}, {"yield", event.yield}, {"unload", event.unload}};
  std::erase_if(all, [](const Change& one) { return one.contacts.empty(); });
  return all;
}

/// Words on one event, or on several that have no room of their own: they stand over the middle of these.
struct Words {
  std::vector<Change> changes;  ///< in the order of time
  double first, last;           ///< places of the events

  /// Contacts that do the same in turn are told together.
  void add(const Words& next) {
    for (const auto& [verb, contacts] : next.changes) {
      if (changes.empty() || changes.back().verb != std::string_view(verb)) changes.push_back({verb, {}});
      auto& list = changes.back().contacts;
      list.insert(list.end(), contacts.begin(), contacts.end());
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    last = next.last;
  }
  /// "3 closes, 1–2 open"
  std::string text() const {
    std::string all;
    for (const auto& [verb, contacts] : changes)
      all += fmt::format("{}{} {}{}", all.empty() ? "" : ", ", numbers(contacts), verb,
                         contacts.size() > 1 ? "" : "s");
    return all;
  }
};

/// Where words are centred and how wide they are, in widths of the axis.
struct Places {
  std::vector<double> at, width;
};

/// Not before the axis, beside whose upper end stands a number, nor too far beyond its end.
Places places(const Axis& axis, const std::vector<Words>& all, double room) {
  Places places;
  for (const auto& one : all) {
    const double wide = pixels_of_letter * static_cast<double>(report::width(one.text()) + 1) / axis.width;
    const double most = 1 + room / axis.width - 0.5 * wide;
    places.width.push_back(wide);
    places.at.push_back(std::max(std::min(0.5 * (one.first + one.last), most), 0.5 * wide));
  }
  return places;
}

/// In which rows the words stand; those without room join the words before them.
std::vector<int> arrange(const Axis& axis, double room, std::vector<Words>& all) {
  const auto [at, width] = places(axis, all, room);
  const auto row = rows_of_words(at, width, rows);
  const auto none = std::find(row.begin() + 1, row.end(), -1) - row.begin();
  if (none == std::ssize(row)) return row;
  all[static_cast<std::size_t>(none) - 1].add(all[static_cast<std::size_t>(none)]);
  all.erase(all.begin() + none);
  return arrange(axis, room, all);
}

std::string labels(const Axis& axis, const std::vector<impact::Event>& shown, double room) {
  std::vector<Words> all;
  for (const auto& event : shown)
    all.push_back({changes(event), axis.place(event.time), axis.place(event.time)});
  if (all.empty()) return "";
  const auto row = arrange(axis, room, all);
  const auto at = places(axis, all, room).at;
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format(
        "set label '{{/*0.75 {}}}' at graph {:.4f}, graph {:.3f} center textcolor rgb '#3b4550'\n",
        all[i].text(), at[i], 1.04 + 0.06 * row[i]);
  return text;
}

}  // namespace

std::string event_marks(const std::vector<impact::Event>& events, const Display& time, const Window& window,
                        double width, std::optional<double> room) {
  const Axis axis{time, window, width};
  std::vector<impact::Event> shown;
  std::copy_if(events.begin(), events.end(), std::back_inserter(shown),
               [&](const auto& event) { return axis.shows(event.time); });
  if (shown.size() > most_lines) return lines(axis, shown);
  return shades_of(axis, events) + lines(axis, shown) + (room ? labels(axis, shown, *room) : "");
}

}  // namespace mariotte::report
