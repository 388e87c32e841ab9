#include "mariotte/report/figure/event_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/figure/label_places.hpp"

namespace mariotte::report {
namespace {

constexpr double pixels_of_letter = 5.2;
constexpr int word_rows = 2;
constexpr std::size_t most_told = 3;  // changes of several events told together

/// "1–2 close"
struct Change {
  const char* verb;
  std::vector<Index> contacts;

  std::string text() const {
    return fmt::format("{} {}{}", numbers(contacts), verb, contacts.size() > 1 ? "" : "s");
  }
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

  void add(const Words& next) {
    changes.insert(changes.end(), next.changes.begin(), next.changes.end());
    last = next.last;
  }
  /// "3 closes, 1 opens"; of many the first and the last.
  std::string text() const {
    if (changes.size() > most_told) return changes.front().text() + " … " + changes.back().text();
    std::string all;
    for (const auto& one : changes) all += (all.empty() ? "" : ", ") + one.text();
    return all;
  }
};

/// Where words are centred and how wide they are, in widths of the axis.
struct WordPlaces {
  std::vector<double> at, width;
};

/// Not before the axis, beside whose upper end stands a number, nor too far beyond its end.
WordPlaces places(const std::vector<Words>& all, double axis, double room) {
  WordPlaces places;
  for (const auto& one : all) {
    const double one_width = pixels_of_letter * static_cast<double>(report::width(one.text()) + 1) / axis;
    const double most = 1 + room / axis - 0.5 * one_width;
    places.width.push_back(one_width);
    places.at.push_back(std::max(std::min(0.5 * (one.first + one.last), most), 0.5 * one_width));
  }
  return places;
}

/// In which rows the words stand; those without room join the words before them.
std::vector<int> arrange(double axis, double room, std::vector<Words>& all) {
  const auto [at, width] = places(all, axis, room);
  const auto row = rows_of_words(at, width, word_rows);
  const auto none = std::find(row.begin() + 1, row.end(), -1) - row.begin();
  if (none == std::ssize(row)) return row;
  all[static_cast<std::size_t>(none) - 1].add(all[static_cast<std::size_t>(none)]);
  all.erase(all.begin() + none);
  return arrange(axis, room, all);
}

}  // namespace

std::string event_words(const std::vector<impact::Event>& events, const Window& window, double width,
                        double room) {
  std::vector<Words> all;
  for (const auto& event : events) {
    const double place = (event.time - window.start) / (window.end - window.start);
    all.push_back({changes(event), place, place});
  }
  if (all.empty()) return "";
  const auto row = arrange(width, room, all);
  const auto [at, widths] = places(all, width, room);
  if (*std::max_element(widths.begin(), widths.end()) > 1 + room / width) return "";  // lines alone mark them
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format(
        "set label '{{/*0.75 {}}}' at graph {:.4f}, graph {:.3f} center textcolor rgb '#3b4550'\n",
        all[i].text(), at[i], 1.04 + 0.06 * row[i]);
  return text;
}

}  // namespace mariotte::report
