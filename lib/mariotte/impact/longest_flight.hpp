// The longest flight of a result before contacts that push together.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "mariotte/core/flights.hpp"

namespace mariotte::impact {

/// Of contacts with lists of their `periods`.
template <class Contacts>
double longest_flight(const Contacts& contacts) {
  std::vector<std::pair<double, bool>> events;  // what ends at the instant of a beginning comes behind it
  for (const auto& contact : contacts)
    for (const auto& period : contact.periods) {
      events.emplace_back(period.start, false);
      if (period.end) events.emplace_back(*period.end, true);
    }
  std::sort(events.begin(), events.end());
  Flights flights;
  for (const auto& [time, ends] : events) ends ? flights.end(time) : flights.begin(time);
  return flights.longest();
}

}  // namespace mariotte::impact
