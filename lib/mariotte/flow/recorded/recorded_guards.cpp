#include "mariotte/flow/recorded/recorded_guards.hpp"

#include "mariotte/flow/series_guards.hpp"

namespace mariotte::flow {

using series::TapeClock;
using series::TapeSeries;

Index landing_guard(const Recording& recording, const TapeClock& clock) {
  if (clock.kind != TapeClock::Kind::root) return -1;
  for (const auto& one : recording.contact)
    if (one.root == clock.root) return one.open;
  return -1;
}

SeriesEnd end_of_step(const Recording& recording, const TapeSeries& series, const TapeClock& clock,
                      double reach, double rounding) {
  SeriesEnd end{reach};
  const Index landing = landing_guard(recording, clock);
  if (landing >= 0) look(landing, {series.row(clock.root)}, rounding, end);
  for (const auto& one : recording.guard)
    if (one.guard != landing) look(one.guard, {series.row(one.place), one.sign}, rounding, end);
  return end;
}

}  // namespace mariotte::flow
