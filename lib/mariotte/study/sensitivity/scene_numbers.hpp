// Keys of a scene as numbers that its model depends on.
#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "mariotte/impact/sensitivity/parameter.hpp"
#include "mariotte/scene/document.hpp"
#include "mariotte/scene/key_path.hpp"

namespace mariotte::study {

/// A number of a scene, and what steps are a share of: its own size, or of a zero that of others like it.
struct SceneNumber {
  double value = 0;
  double size = 0;
  Dimension dimension = {};
};

/// The number that a key leads to, if the scene has it and reads it as one.
std::optional<SceneNumber> number_at(scene::Document document, const std::string& key);

/// The key, or those of all elements of the list that it leads to.
std::vector<std::string> elements_of(scene::Document document, const std::string& key);

/// The number by which slopes are asked. Throws SceneError if it is none, or infinite.
SceneNumber expect_number(const scene::Document& document, const std::string& key);

/// "mass[0]" is asked for by "mass[0]" and "mass", "contact[1].stiffness" by "contact[1]" and "contact", too.
bool is_asked_for(const std::string& name, const std::string& key);

/// The scene read again with another value.
template <class Model>
impact::Parameter<Model> scene_parameter(const scene::Document& document, const std::string& name,
                                         const std::string& key, const SceneNumber& number) {
  return {name, number.value, 0.01 * number.size,
          [copy = std::make_shared<scene::Document>(document), key](double to, Model& moved) {
            auto& node = locate(copy->source, copy->tree, key, {});
            const auto before = node.value;
            node.value = to;
            auto scene = resolve(*copy);
            node.value = before;
            moved = std::get<Model>(std::move(scene.model));
          }};
}

/// The step of the stencil, or as much less as lets the scene be read at four times that on both sides, with
/// numbers of its model that move smoothly: bodies that are moved farther may overlap, or touch others, and
/// the speed at which a restitution holds may be that of another contact. Throws SceneError that names the
/// key where there is no such step.
double step_around(scene::Document document, const std::string& key, const SceneNumber& number);

/// Whether the key is the time limit of the run.
bool is_time_limit(const scene::Document& document, const std::string& key);

template <class Model>
impact::Parameter<Model> number_of_scene(const scene::Document& document, const std::string& name,
                                         const std::string& key) {
  const auto number = expect_number(document, key);
  auto parameter = scene_parameter<Model>(document, name, key, number);
  parameter.step = step_around(document, key, number);
  parameter.limit = is_time_limit(document, key) ? 1 : 0;
  return parameter;
}

}  // namespace mariotte::study
