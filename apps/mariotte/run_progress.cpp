#include "run_progress.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/core/counted.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::command {
namespace {

constexpr Index events_between_looks = 256;  // at the clock
/// Share of the time limit before which nothing is forecast: contacts are densest at the beginning.
constexpr double forecast_after = 0.1;

}  // namespace

std::string progress_text(const impact::Progress& progress, double max_time, double taken) {
  const auto time = report::display_for(std::vector{progress.time}, "s");
  auto text = fmt::format("at {} {} after {:.0f} s, {}", report::shown(time, progress.time), time.unit, taken,
                          counted(progress.events, "event"));
  if (std::isfinite(max_time) && progress.time > forecast_after * max_time)
    text += fmt::format("; about {:.0f} s more to the time limit", taken * (max_time / progress.time - 1));
  return text;
}

void RunProgress::operator()(const impact::Progress& progress) {
  if (++asked_ % events_between_looks != 0 || !line_.is_due()) return;
  line_.show(progress_text(progress, max_time_, line_.seconds()));
}

}  // namespace mariotte::command
