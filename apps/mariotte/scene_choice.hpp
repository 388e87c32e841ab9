// The scene a subcommand works on, as the command line names it.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "mariotte/scene/document.hpp"

namespace mariotte::command {

struct SceneChoice {
  std::string path;
  scene::Overrides set;
  bool quiet = false;
};

/// Declare SCENE, --set and --quiet.
void add_scene_choice(CLI::App& command, SceneChoice& choice);

/// Declare --set and --quiet.
void add_overrides(CLI::App& command, SceneChoice& choice);

/// Declare --accuracy and --flow, which stand for a --set of their key.
void add_run_options(CLI::App& command, SceneChoice& choice);

/// Parse the scene. Throws scene::FileError or scene::SceneError.
scene::Document open(const SceneChoice& choice);

/// What it describes; its warnings are printed unless quiet. Throws scene::SceneError.
scene::Scene resolve(const SceneChoice& choice, const scene::Document& document,
                     scene::Purpose purpose = scene::Purpose::simulation);

/// Both at once.
scene::Scene read(const SceneChoice& choice, scene::Purpose purpose = scene::Purpose::simulation);

}  // namespace mariotte::command
