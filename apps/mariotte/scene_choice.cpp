#include "scene_choice.hpp"

#include "command_line/checks.hpp"
#include "command_line/terminal.hpp"

namespace mariotte::command {

void add_scene_choice(CLI::App& command, SceneChoice& choice) {
  command.add_option("SCENE", choice.path, "Scene file (TOML)")->required();
  add_overrides(command, choice);
}

void add_overrides(CLI::App& command, SceneChoice& choice) {
  command
      .add_option("--set", choice.set, "Replace one value of the scene; lists count from 0; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_flag("-q,--quiet", choice.quiet, "No warnings");
}

void add_run_options(CLI::App& command, SceneChoice& choice) {
  const auto sets = [&choice](const char* key) {
    return [&choice, key](const std::string& value) { choice.set.push_back(key + ("=" + value)); };
  };
  command
      .add_option_function<std::string>("--accuracy", sets("run.accuracy"),
                                        "Wanted error of the final velocities / largest speed")
      ->check(is_accuracy, "");
  command
      .add_option_function<std::string>("--flow", sets("run.flow"),
                                        "How contact phases are computed; auto chooses")
      ->check(is_flow, "");
}

scene::Document open(const SceneChoice& choice) {
  return scene::open(choice.path, choice.set);
}

scene::Scene resolve(const SceneChoice& choice, const scene::Document& document, scene::Purpose purpose) {
  auto scene = scene::resolve(document, purpose);
  if (!choice.quiet)
    for (const auto& one : scene.warnings) warning(one);
  return scene;
}

scene::Scene read(const SceneChoice& choice, scene::Purpose purpose) {
  return resolve(choice, open(choice), purpose);
}

}  // namespace mariotte::command
