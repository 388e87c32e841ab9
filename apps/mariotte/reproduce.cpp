#include "command.hpp"
#include "companion.hpp"

namespace mariotte::command {

void add_reproduce(CLI::App& app) {
  auto* command = app.add_subcommand("reproduce", "Figures of the papers, computed again and checked");
  command->prefix_command();
  command->set_help_flag();
  command->callback([command] { become("paper_figures", command->remaining()); });
}

}  // namespace mariotte::command
