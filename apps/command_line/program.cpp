#include "command_line/program.hpp"

#include <csignal>

#include "command_line/exit_code.hpp"
#include "command_line/parser.hpp"
#include "command_line/terminal.hpp"

namespace mariotte::command {

int run_program(const Command& program, int argc, char** argv) noexcept {
  // A closed pipe and a file at its size limit are errors to report, not reasons to die silently.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return guarded([&] {
    speak_as(program.name);
    return parse(program, argc, argv)();
  });
}

}  // namespace mariotte::command
