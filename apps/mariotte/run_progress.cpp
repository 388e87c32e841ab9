#include "run_progress.hpp"

#include "mariotte/report/run_progress.hpp"

namespace mariotte::command {
namespace {

constexpr Index events_between_looks = 256;  // at the clock

}  // namespace

void RunProgress::operator()(const impact::Progress& progress) {
  if (++asked_ % events_between_looks != 0 || !line_.is_due()) return;
  line_.show(report::progress_text(progress, max_time_, line_.seconds()));
}

}  // namespace mariotte::command
