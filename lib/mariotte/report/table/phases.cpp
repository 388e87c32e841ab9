#include "mariotte/report/table/phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mariotte/report/csv/columns.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_marked = 12;                           // more words would cover each other
constexpr std::array shades = {"#f1f4f8", "#e6ecf3", "#dce4ee"};  // of one, two, three and more contacts

std::string shade(double from, double to, std::size_t closed) {
  if (closed == 0 || !(to > from)) return "";
  return fmt::format(
      "set object rectangle from {:.8g}, graph 0 to {:.8g}, graph 1 behind fillcolor rgb '{}' "
      "fillstyle solid noborder\n",
      from, to, shades[std::min(closed, shades.size()) - 1]);
}

std::string mark(const impact::Event& event, double place) {
  std::string words;
  if (!event.close.empty()) words = numbers(event.close) + " close";
  if (!event.open.empty()) words += (words.empty() ? "" : ", ") + numbers(event.open) + " open";
  return fmt::format(
      "set arrow from {0:.8g}, graph 0 to {0:.8g}, graph 1 nohead back dashtype 2 linecolor rgb '#9aa5b1'\n"
      "set label '{1}' at {0:.8g}, graph 0.99 rotate by 90 right offset 0.8,0 font ',11' "
      "textcolor rgb '#5f6b78'\n",
      place, words);
}

}  // namespace

std::string phase_marks(const std::vector<impact::Event>& events, const Display& time, double end) {
  std::string text;
  if (events.size() > most_marked) return text;
  std::size_t closed = 0;
  for (std::size_t i = 0; i < events.size() && events[i].time <= end; ++i) {
    closed += events[i].close.size() - events[i].open.size();
    const double next = i + 1 < events.size() ? std::min(events[i + 1].time, end) : end;
    text += mark(events[i], time.factor * events[i].time);
    text += shade(time.factor * events[i].time, time.factor * next, closed);
  }
  return text;
}

}  // namespace mariotte::report
