#include "help_pages.hpp"

#include "command.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/page/provenance.hpp"

namespace mariotte::command {

void add_help_pages(CLI::App& app) {
  auto* man = app.add_subcommand("man", "Print a page for man");
  man->footer("Example:\n  mariotte man | man -l -\n");
  man->callback([&app] { print(man_page(app, report::provenance().version)); });
  auto* completion = app.add_subcommand("completion", "Print completions for bash");
  completion->footer("Example:\n  mariotte completion >> ~/.bashrc\n");
  completion->callback([&app] { print(bash_completion(app)); });
}

}  // namespace mariotte::command
