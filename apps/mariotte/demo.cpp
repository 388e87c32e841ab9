#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "demo_scene.hpp"
#include "mariotte/report/table/table.hpp"

namespace mariotte::command {
namespace {

int demo() {
  const auto scene = scene::parse(demo_scene, "demo");
  const auto impact = impact::simulate(std::get<model::Chain>(scene.model), scene.run);
  print(report::table(impact, scene));
  return exit_code(impact.ending);
}

}  // namespace

Command demo_command() {
  return {.name = "demo",
          .about = "Newton's cradle of five steel balls, built in",
          .footer = "Example:\n  mariotte demo\n",
          .act = demo};
}

}  // namespace mariotte::command
