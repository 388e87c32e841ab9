#include "progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "command_line/terminal.hpp"

namespace mariotte::command {
namespace {

constexpr int bar_width = 30;
constexpr auto bar_interval = std::chrono::milliseconds(200);
constexpr auto line_interval = std::chrono::seconds(10);

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string bar(double fraction, int width) {
  const auto filled = static_cast<std::size_t>(fraction * width);
  return "[" + std::string(filled, '#') + std::string(static_cast<std::size_t>(width) - filled, '-') + "]  ";
}

}  // namespace

std::string progress_text(Index done, Index points, double seconds, int width) {
  const double fraction = points > 0 ? static_cast<double>(done) / static_cast<double>(points) : 1;
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  std::string text = width > 0 ? bar(fraction, width) : "";
  text += fmt::format("{:.0f} %  {} of {} points  {:.3g}/s", 100 * fraction, done, points, rate);
  if (rate > 0) text += fmt::format("  {} left", clock_text(static_cast<double>(points - done) / rate));
  return text;
}

ProgressLine::ProgressLine(Index points, bool quiet)
    : points_(points), quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(Index done) {
  const auto now = Clock::now();
  if (quiet_ || (terminal_ ? now - shown_ < bar_interval : now - shown_ < line_interval)) return;
  shown_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (!terminal_) return note(progress_text(done, points_, seconds, 0));
  drawn_ = true;
  std::fprintf(stderr, "\r\033[K%s", progress_text(done, points_, seconds, bar_width).c_str());
  std::fflush(stderr);
}

}  // namespace mariotte::command
