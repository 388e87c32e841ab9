#include <memory>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/json.hpp"
#include "mariotte/report/table.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct Check {
  SceneChoice scene;
  bool json = false;
};

int check(const Check& options) {
  const auto scene = read(options.scene);
  print(options.json ? report::text(report::json(scene)) : report::table(scene));
  return ExitCode::ok;
}

constexpr const char* examples = R"(Examples:
  mariotte check cradle.toml
  mariotte check cradle.toml --set "chain.velocity[0]=2 m/s" --json
)";

}  // namespace

void add_check(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("check", "Validate a scene and show it in SI units; run nothing");
  auto options = std::make_shared<Check>();
  add_scene_choice(*command, options->scene);
  command->add_flag("--json", options->json, "One JSON object on stdout");
  command->footer(examples);
  command->callback([options, &code] { code = check(*options); });
}

}  // namespace mariotte::command
