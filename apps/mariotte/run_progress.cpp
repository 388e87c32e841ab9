#include "run_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "command_line/terminal.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::command {
namespace {

constexpr Index events_between_looks = 256;  // at the clock

bool on_terminal() {
  return ::isatty(STDERR_FILENO) != 0;
}

}  // namespace

RunProgress::~RunProgress() {
  if (shown_ && on_terminal()) std::fputs("\r\033[K", stderr);
}

void RunProgress::operator()(const impact::Progress& progress) {
  if (++asked_ % events_between_looks != 0 || Clock::now() < next_) return;
  const double taken = std::chrono::duration<double>(Clock::now() - start_).count();
  const double done = std::max(progress.time / limits_.max_time, static_cast<double>(progress.events) /
                                                                     static_cast<double>(limits_.max_events));
  const auto time = report::display_for(std::vector{progress.time}, "s");
  const auto line = fmt::format("at {} {} after {:.0f} s, {} events; at most {:.0f} s more",
                                report::shown(time, progress.time), time.unit, taken, progress.events,
                                taken * (1 / done - 1));
  if (on_terminal())
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
  else
    note(line);
  shown_ = true;
  next_ = Clock::now() + (on_terminal() ? std::chrono::milliseconds(500) : std::chrono::milliseconds(10000));
}

}  // namespace mariotte::command
