#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "mariotte/report/table/modes_report.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct Modes {
  SceneChoice scene;
  std::string force;
  bool shapes = false;
  bool json = false;
};

std::optional<double> end_force(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return positive_quantity("--force", text, dimension::stiffness(0));
}

report::Json json(const Modes& options, const study::Modes& found, const scene::Scene& scene) {
  report::Json all = {{"title", scene.title}};
  all.update(report::json(found));
  if (options.shapes) all["shape"] = found.vibrations.shape;
  return all;
}

int modes(const Modes& options) {
  const auto scene = read(options.scene, scene::Purpose::rest);
  const auto found = study::modes(scene, end_force(options.force));
  if (options.json)
    print(report::text(json(options, found, scene)));
  else
    print(report::table(found, scene.title));
  return ExitCode::ok;
}

constexpr const char* modes_examples = R"(Examples:
  mariotte modes pressed_row.toml
  mariotte modes row.toml --force "20 N" --json --shapes

The row or network in static equilibrium, and its small vibrations about it, without dampers. Walls, gravity
and precompression hold a row; --force stands for them at free ends.
)";

}  // namespace

Command modes_command() {
  auto options = std::make_shared<Modes>();
  return {
      .name = "modes",
      .about = "Find the frequencies of small vibrations about static equilibrium",
      .footer = modes_examples,
      .options = joined({scene_options(options->scene),
                         {{"--force", &options->force, "Press the ends of a row with it", {.value = "FORCE"}},
                          {"--shapes", &options->shapes, "Displacements of each mode", {.needs = {"--json"}}},
                          {"--json", &options->json, "One JSON object on stdout"}}}),
      .act = [options] { return modes(*options); }};
}

}  // namespace mariotte::command
