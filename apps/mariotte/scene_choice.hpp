// The scene a subcommand works on, as the command line names it.
#pragma once
#include <string>

#include "command_line/declaration.hpp"
#include "mariotte/scene/document.hpp"

namespace mariotte::command {

struct SceneChoice {
  std::string path;
  scene::Overrides set;
  bool quiet = false;
};

/// SCENE, --set and --quiet.
OptionList scene_options(SceneChoice& choice);

/// --set and --quiet.
OptionList override_options(SceneChoice& choice);

/// --accuracy and --flow, which stand for a --set of their key.
OptionList run_options(SceneChoice& choice);

/// Parse the scene. Throws scene::FileError or scene::SceneError.
scene::Document open(const SceneChoice& choice);

/// What it describes; its warnings are printed unless quiet. Throws scene::SceneError.
scene::Scene resolve(const SceneChoice& choice, const scene::Document& document,
                     scene::Purpose purpose = scene::Purpose::simulation);

/// Both at once.
scene::Scene read(const SceneChoice& choice, scene::Purpose purpose = scene::Purpose::simulation);

}  // namespace mariotte::command
