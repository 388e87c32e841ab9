// Where errors grow by flying: an error of a velocity moves a body the more the longer it flies, and so the
// instants at which contacts that push together close.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

namespace mariotte::impact {

/// Told of contacts that begin and end to push, in order of time.
class Flights {
 public:
  void begin(double time) {
    if (closed_++ > 0) {
      is_joined_ = true;
      return;
    }
    quiet_ = has_pushed_ ? time - last_ : 0;
    began_ = time;
    has_pushed_ = true;
    is_joined_ = false;
  }
  void end(double time) {
    last_ = time;
    if (--closed_ == 0 && is_joined_ && quiet_ > 0) longest_ = std::max(longest_, quiet_ / (time - began_));
  }
  /// How long nothing pushed before two contacts did so together, over how long they did; the longest.
  double longest() const { return longest_; }

 private:
  int closed_ = 0;
  bool has_pushed_ = false, is_joined_ = false;
  double quiet_ = 0, began_ = 0, last_ = 0, longest_ = 0;
};

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
