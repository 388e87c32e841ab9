#include "run_progress.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/number.hpp"

namespace mariotte::command {
namespace {

constexpr Index events_between_looks = 256;  // at the clock

}  // namespace

void RunProgress::operator()(const impact::Progress& progress) {
  if (++asked_ % events_between_looks != 0 || !line_.is_due()) return;
  const double taken = line_.seconds();
  const double done = std::max(progress.time / limits_.max_time, static_cast<double>(progress.events) /
                                                                     static_cast<double>(limits_.max_events));
  const auto time = report::display_for(std::vector{progress.time}, "s");
  line_.show(fmt::format("at {} {} after {:.0f} s, {} events; at most {:.0f} s more",
                         report::shown(time, progress.time), time.unit, taken, progress.events,
                         taken * (1 / done - 1)));
}

}  // namespace mariotte::command
