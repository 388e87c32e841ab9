#include "command_line/terminal.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "mariotte/report/page/files.hpp"

namespace mariotte::command {
namespace {

std::string speaker = "mariotte";

void say(const char* kind, std::string_view message) {
  std::fprintf(stderr, "%s: %s%.*s\n", speaker.c_str(), kind, static_cast<int>(message.size()),
               message.data());
}

}  // namespace

void speak_as(std::string program) {
  speaker = std::move(program);
}

void print(std::string_view text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) throw ReaderGone{};
  throw report::FileError(std::string("cannot write to standard output: ") + std::strerror(errno));
}

void error(std::string_view message, Fault fault) noexcept {
  std::fprintf(stderr, "%s: error: %.*s [%.*s]\n", speaker.c_str(), static_cast<int>(message.size()),
               message.data(), static_cast<int>(fault.code.size()), fault.code.data());
}

void warning(std::string_view message) noexcept {
  say("warning: ", message);
}

void note(std::string_view message) noexcept {
  say("", message);
}

}  // namespace mariotte::command
