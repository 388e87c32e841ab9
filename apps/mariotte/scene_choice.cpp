#include "scene_choice.hpp"

#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "mariotte/flow/kind.hpp"

namespace mariotte::command {

OptionList scene_options(SceneChoice& choice) {
  return joined(
      {{{"SCENE", &choice.path, "Scene file (TOML)", {.required = true}}}, override_options(choice)});
}

OptionList override_options(SceneChoice& choice) {
  return {{"--set",
           &choice.set,
           "Replace one value of the scene; lists count from 0; may be repeated",
           {.value = "KEY=VALUE", .takes_one = true}},
          {"-q,--quiet", &choice.quiet, "No warnings"}};
}

OptionList run_options(SceneChoice& choice) {
  const auto sets = [&choice](const char* key) {
    return [&choice, key](const std::string& value) { choice.set.push_back(key + ("=" + value)); };
  };
  Words flows = {"auto"};
  for (const auto kind : flow::kinds)
    if (kind != flow::Kind::ballistic) flows.emplace_back(flow::name(kind));
  return {{"--accuracy",
           sets("run.accuracy"),
           "Wanted error of the final velocities / largest speed",
           {.check = is_accuracy}},
          {"--flow",
           sets("run.flow"),
           "How contact phases are computed; auto chooses",
           {.check = is_flow, .choices = flows}}};
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
