#include <fmt/format.h>

#include <map>

#include "command.hpp"
#include "companion.hpp"

namespace mariotte::command {
namespace {

const std::map<std::string, std::string> programs = {{"icr-table", "icr_table"},
                                                     {"scaling", "scaling_study"},
                                                     {"stiffness", "stiffness_study"},
                                                     {"stress", "stress_study"},
                                                     {"work-precision", "work_precision"}};

}  // namespace

void add_study(CLI::App& app) {
  auto* command = app.add_subcommand(
      "study", "Programs of their own: icr-table, scaling, stiffness, stress, work-precision");
  command->footer(
      "Examples:\n  mariotte study icr-table --kappa 0.1:10:41:log --out kappa.csv\n  mariotte study "
      "stiffness --quick\n  mariotte study scaling --help\n  mariotte study work-precision --help\n");
  command->require_subcommand(1);
  for (const auto& [study, program] : programs) {
    auto* one = command->add_subcommand(study, fmt::format("The same as {}", program));
    one->prefix_command();
    one->set_help_flag();
    one->callback([one, name = program] { become(name, one->remaining()); });
  }
}

}  // namespace mariotte::command
