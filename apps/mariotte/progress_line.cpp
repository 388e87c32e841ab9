#include "progress_line.hpp"

#include <fmt/format.h>

#include "mariotte/core/counted.hpp"

namespace mariotte::command {
namespace {

constexpr int bar_width = 30;

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
  text += fmt::format("{:.0f} %  {} of {}  {:.3g}/s", 100 * fraction, done, counted(points, "point"), rate);
  if (rate > 0) text += fmt::format("  {} left", clock_text(static_cast<double>(points - done) / rate));
  return text;
}

void ProgressLine::show(Index done) {
  if (quiet_ || !line_.is_due()) return;
  line_.show(progress_text(done, points_, line_.seconds(), line_.on_terminal() ? bar_width : 0));
}

}  // namespace mariotte::command
