#include "help_pages.hpp"

#include <memory>

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
  auto shell = std::make_shared<std::string>("bash");
  return {.name = "completion",
          .about = "Print completions for a shell",
          .footer =
              "Examples:\n  mariotte completion >> ~/.bashrc\n"
              "  mariotte completion fish > ~/.config/fish/completions/mariotte.fish\n",
          .options = {{"SHELL",
                       shell.get(),
                       "For which shell (default: bash)",
                       {.check = OneOf{{"bash", "zsh", "fish"}}}}},
          .act = [&program, shell] {
            print(completion(help_page(program), *shell));
            return ExitCode::ok;
          }};
}

}  // namespace mariotte::command
