#include "mariotte/report/run_progress.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mariotte/core/counted.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr double forecast_after = 0.1;  // share of the time limit

}  // namespace

std::string progress_text(const impact::Progress& progress, double max_time, double taken) {
  const auto time = display_for(std::vector{progress.time}, "s");
  auto text = fmt::format("at {} {} after {:.0f} s, {}", rounded(time.factor * progress.time, 6), time.unit,
                          taken, counted(progress.events, "event"));
  if (std::isfinite(max_time) && progress.time > forecast_after * max_time)
    text += fmt::format("; about {:.0f} s more to the time limit", taken * (max_time / progress.time - 1));
  return text;
}

}  // namespace mariotte::report
