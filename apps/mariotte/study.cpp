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

Command study_command() {
  Command command{
      .name = "study",
      .about = "Programs of their own: icr-table, scaling, stiffness, stress, work-precision",
      .footer =
          "Examples:\n  mariotte study icr-table --kappa 0.1:10:41:log --out kappa.csv\n  mariotte study "
          "stiffness --quick\n  mariotte study scaling --help\n  mariotte study work-precision --help\n"};
  for (const auto& [study, program] : programs)
    command.commands.push_back(
        {.name = study,
         .about = fmt::format("The same as {}", program),
         .pass_on = [name = program](const Words& rest) -> int { become(name, rest); }});
  return command;
}

}  // namespace mariotte::command
