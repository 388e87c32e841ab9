#include "help_pages.hpp"

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/page/provenance.hpp"

namespace mariotte::command {

Command man_command(const Command& program) {
  return {.name = "man",
          .about = "Print a page for man",
          .footer = "Example:\n  mariotte man | man -l -\n",
          .act = [&program] {
            print(man_page(help_page(program), report::provenance().version));
            return ExitCode::ok;
          }};
}

Command completion_command(const Command& program) {
  return {.name = "completion",
          .about = "Print completions for bash",
          .footer = "Example:\n  mariotte completion >> ~/.bashrc\n",
          .act = [&program] {
            print(bash_completion(help_page(program)));
            return ExitCode::ok;
          }};
}

}  // namespace mariotte::command
