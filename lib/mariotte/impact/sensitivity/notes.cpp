#include "mariotte/impact/sensitivity/notes.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

#include "mariotte/core/error.hpp"

namespace mariotte::impact {
namespace {

/// "errors grow so much that slopes may be off by 2e-06 of their size".
SlopeNote doubt(const std::string& cause, double error, const std::string& more = {}) {
  char size[32];
  std::snprintf(size, sizeof size, "%.1g", error);
  return {.text = cause + " that slopes may be off by " + size + " of their size" + more, .error = error};
}

}  // namespace

SlopeNote grazing_note(const DelicateEvent& event, double unit, Names outcomes) {
  char text[200];
  std::snprintf(
      text, sizeof text,
      "an event of %s at %.6g s is grazed: its guard crosses zero at %.2g of the natural speed, the "
      "slowest of all",
      event.what.c_str(), event.time * unit, event.speed);
  return {.text = text + std::string("; slopes hold no further than about the square of that from here"),
          .outcomes = std::move(outcomes)};
}

SlopeNote near_miss_note(const std::string& what, double gap) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%s turns %.2g m before it would close: slopes are those of a contact that does not",
                what.c_str(), gap);
  return {.text = text};
}

SlopeNote slip_from_rest_note() {
  return {.text =
              "a slip in space starts from rest: its direction is known no better than rounding at "
              "first, so slopes are not resolved there and may be wrong"};
}

SlopeNote unknown_way_note() {
  return {.text =
              "slips in space start from rest at one instant: slopes do not know how their first directions "
              "move, and may be wrong"};
}

SlopeNote turning_slip_note(double error) {
  return doubt("a slip in space passes so near to rest", error, ": friction turns about there");
}

SlopeNote shared_onset_note(double error) {
  return doubt("contacts close at one instant, slowly, and parameters draw them apart so far", error);
}

SlopeNote shrinking_note(double error) {
  return doubt("slopes on the way are so much larger than those of the outcome", error);
}

SlopeNote growing_note(double error) {
  return doubt("errors grow so much on the way", error);
}

SlopeNote shared_ending_note(Names outcomes, Names parameters) {
  return {.text =
              "several contacts end the run at one instant, and parameters draw their times apart: the "
              "time of the ending is the later one, with slopes that differ on both sides",
          .outcomes = std::move(outcomes),
          .parameters = std::move(parameters)};
}

SlopeNote noise_ending_note(Names outcomes) {
  return {.text =
              "what ended the run is a motion within its accuracy, so its time has no slopes, nor has what "
              "still moves then",
          .outcomes = std::move(outcomes)};
}

SlopeNote coincidence_note(const CoincidentEvents& events, double unit, Names outcomes, Names parameters) {
  char text[160], more[160] = "slopes of velocities hold on both sides as far as forces have no jumps there";
  std::snprintf(text, sizeof text,
                "events of %s and %s fall together at %.6g s, and parameters draw them apart; ",
                events.first.c_str(), events.second.c_str(), events.time * unit);
  if (events.error > 0 && std::isfinite(events.error))
    std::snprintf(more, sizeof more,
                  "slopes may be off by %.1g of their size, since a damper begins within depths that are not "
                  "resolved",
                  events.error);
  return {.text = text + std::string(more),
          .outcomes = std::move(outcomes),
          .parameters = std::move(parameters),
          .error = events.error};
}

SlopeNote near_closing_note(const std::string& what, double speed, Names outcomes, Names parameters) {
  char text[160];
  std::snprintf(text, sizeof text, "%s ends with %.2g m/s between its balls, and parameters move that",
                what.c_str(), speed);
  return {.text = text + std::string(": where they approach it closes again; slopes hold on the side where "
                                     "they part"),
          .outcomes = std::move(outcomes),
          .parameters = std::move(parameters)};
}

SlopeNote closing_in_noise_note(const std::string& what, Names pushed) {
  return {.text = "whether " + what +
                  " closes once more cannot be told, so the time of the ending may be another, and slopes of "
                  "what it would push",
          .outcomes = std::move(pushed)};
}

SlopeNote hardly_touching_note(const std::string& what, double speed, Names parameters) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%s touches at the start with %.2g m/s between its balls, and parameters turn that",
                what.c_str(), speed);
  return {.text = text + std::string(": slopes hold on its side of rest"),
          .parameters = std::move(parameters)};
}

SlopeNote near_yield_note(const std::string& what, double depth) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%s turns %.2g m before it would yield: slopes are those of a contact that does not",
                what.c_str(), depth);
  return {.text = text};
}

SlopeNote waiting_note(Names parameters) {
  return {.text =
              "slopes that are missing are by gaps of zero of linear contacts that touch at rest until "
              "the wave comes, and by velocities of their balls: pressed such a contact acts at once, "
              "drawn apart not at all",
          .parameters = std::move(parameters)};
}

SlopeNote slow_ending_note(double error, Names outcomes) {
  char text[160];
  std::snprintf(text, sizeof text,
                "what ends the run crosses so slowly that slopes of its time may be off by %.1g of the time",
                error);
  return {.text = text, .outcomes = std::move(outcomes), .error = error};
}

SlopeNote unresolved_note(double error) {
  char text[160];
  std::snprintf(text, sizeof text, "forces change so steeply that slopes are resolved to %.1g of their size",
                error);
  return {.text = text, .error = error};
}

SlopeNote long_way_note(double error) {
  return doubt("indentations are so small beside the way to the first contact", error);
}

SlopeNote faded_spring_note(Names outcomes) {
  auto text = outcomes.front() +
              " has no slopes: Mindlin's spring holds so long that what it loses last is met at a depth "
              "that is rounding";
  return {.text = std::move(text), .outcomes = std::move(outcomes)};
}

SlopeNote fading_spring_note(double error, Names outcomes) {
  char text[200];
  std::snprintf(text, sizeof text,
                "slopes of %s may be off by %.1g of their size: Mindlin's spring holds to hardly any depth",
                outcomes.front().c_str(), error);
  return {.text = text, .outcomes = std::move(outcomes), .error = error};
}

void add_note_of_landing(const std::vector<bool>& moved, Sensitivity& result) {
  auto parameters = names_of(result.parameter, [&](std::size_t c) { return moved[c]; });
  if (parameters.empty()) return;
  result.notes.push_back(
      {.text =
           "a contact closes without slip and starts to slip: where a parameter gives it a slip the other "
           "way, friction turns first, so slopes differ by side; told is that without a turn",
       .parameters = std::move(parameters)});
}

void add_doubt(SlopeNote note, Sensitivity& result) {
  if (note.error > 0.1) {
    note.text += ": they are left out";
    for (auto& outcome : result.outcome)
      for (std::size_t c = 0; c < outcome.slope.size(); ++c)
        if (concerns(note, name_of(outcome), result.parameter[c].name)) outcome.slope[c].reset();
  }
  result.notes.push_back(std::move(note));
}

void leave_out_unbounded(Sensitivity& slopes) {
  SlopeNote note{.text = "slopes that are missing are unbounded: an event is met with no speed at all"};
  std::vector<bool> is_missing(slopes.parameter.size(), false);
  for (auto& outcome : slopes.outcome) {
    bool any = false;
    for (std::size_t c = 0; c < outcome.slope.size(); ++c) {
      auto& slope = outcome.slope[c];
      if (!slope || std::isfinite(*slope)) continue;
      slope.reset();
      any = is_missing[c] = true;
    }
    if (any) note.outcomes.push_back(name_of(outcome));
  }
  if (note.outcomes.empty()) return;
  note.parameters = names_of(slopes.parameter, [&](std::size_t c) { return is_missing[c]; });
  slopes.notes.push_back(std::move(note));
}

void expect_few(Index components, Index parameters) {
  constexpr Index most = 200'000;
  if (components * parameters <= most) return;
  throw InvalidParameter(
      "slopes of " + std::to_string(components) + " components by " + std::to_string(parameters) +
      " parameters are too many; choose parameters, or of a row of power laws one velocity");
}

}  // namespace mariotte::impact
