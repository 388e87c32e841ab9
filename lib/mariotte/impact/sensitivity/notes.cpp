#include "mariotte/impact/sensitivity/notes.hpp"

#include <cmath>
#include <cstdio>

#include "mariotte/core/error.hpp"

namespace mariotte::impact {

std::string grazing_note(const std::string& what, double speed, double time) {
  char text[200];
  std::snprintf(
      text, sizeof text,
      "an event of %s at %.6g s is grazed: its guard crosses zero at %.2g of the natural speed, the "
      "slowest of all",
      what.c_str(), time, speed);
  return text + std::string("; slopes hold no further than about the square of that from here");
}

std::string slip_from_rest_note() {
  return "a slip in space starts from rest: its direction is known no better than rounding at first, so "
         "slopes "
         "are not resolved there and may be wrong";
}

std::string shared_ending_note() {
  return "several contacts end the run at one instant, and parameters draw their times apart: the time of "
         "the "
         "ending is the later one, with slopes that differ on both sides";
}

std::string noise_ending_note() {
  return "what ended the run is a motion within its accuracy, so its time has no slopes";
}

std::string coincidence_note(const std::string& first, const std::string& second, double time) {
  char text[160];
  std::snprintf(text, sizeof text,
                "events of %s and %s fall together at %.6g s, and parameters draw them apart", first.c_str(),
                second.c_str(), time);
  return text + std::string("; slopes of velocities hold on both sides as far as forces have no jumps there");
}

std::string near_closing_note(const std::string& what, double speed) {
  char text[160];
  std::snprintf(text, sizeof text, "%s ends with %.2g m/s between its balls, and parameters move that",
                what.c_str(), speed);
  return text + std::string(": where they approach it closes again; slopes hold on the side where they part");
}

std::string hardly_touching_note(const std::string& what, double speed) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%s touches at the start with %.2g m/s between its balls, and parameters turn that",
                what.c_str(), speed);
  return text + std::string(": slopes hold on its side of rest");
}

std::string waiting_note() {
  return "slopes that are missing are by gaps of zero of linear contacts that touch at rest until the wave "
         "comes, "
         "and by velocities of their balls: pressed such a contact acts at once, drawn apart not at all";
}

std::string slow_ending_note(double error) {
  char text[160];
  std::snprintf(text, sizeof text,
                "what ends the run crosses so slowly that slopes of its time may be off by %.1g of the time",
                error);
  return text;
}

std::string unresolved_note(double error) {
  char text[160];
  std::snprintf(text, sizeof text, "forces change so steeply that slopes are resolved to %.1g of their size",
                error);
  return text;
}

void leave_out_unbounded(Sensitivity& slopes) {
  bool found = false;
  for (auto& outcome : slopes.outcome)
    for (auto& slope : outcome.slope)
      if (slope && !std::isfinite(*slope)) {
        slope.reset();
        found = true;
      }
  if (found)
    slopes.notes.push_back("slopes that are missing are unbounded: an event is met with no speed at all");
}

void expect_few(Index components, Index parameters) {
  constexpr Index most = 200'000;
  if (components * parameters <= most) return;
  throw InvalidParameter(
      "slopes of " + std::to_string(components) + " components by " + std::to_string(parameters) +
      " parameters are too many; choose parameters, or of a row of power laws one velocity");
}

}  // namespace mariotte::impact
