#include "status_line.hpp"

#include <unistd.h>

#include <cstdio>

#include "command_line/terminal.hpp"

namespace mariotte::command {

StatusLine::StatusLine() : terminal_(::isatty(STDERR_FILENO) == 1), due_(start_ + interval()) {}

StatusLine::StatusLine(Clock::duration first) : StatusLine() {
  due_ = start_ + first;
}

StatusLine::~StatusLine() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

StatusLine::Clock::duration StatusLine::interval() const {
  return terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(10);
}

double StatusLine::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void StatusLine::show(const std::string& text) {
  due_ = Clock::now() + interval();
  if (!terminal_) return note(text);
  drawn_ = true;
  std::fprintf(stderr, "\r\033[K%s", text.c_str());
  std::fflush(stderr);
}

}  // namespace mariotte::command
