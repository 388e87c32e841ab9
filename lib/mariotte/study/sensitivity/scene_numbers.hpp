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

/// The value of a key, if the scene has it and reads it as a number.
std::optional<double> value_of(scene::Document document, const std::string& key);

/// The value of a key of which slopes are asked. Throws SceneError if it is no number other than zero.
double expect_value(const scene::Document& document, const std::string& key);

/// "mass[0]" is asked for by "mass[0]" and "mass", "contact[1].stiffness" by "contact[1]" and "contact", too.
bool is_asked_for(const std::string& name, const std::string& key);

/// The scene read again with another value.
template <class Model>
impact::Parameter<Model> scene_parameter(const scene::Document& document, const std::string& name,
                                         const std::string& key, double value) {
  return {name, value, 0.01 * std::abs(value),
          [copy = std::make_shared<scene::Document>(document), key](double moved) {
            auto& node = locate(copy->source, copy->tree, key, {});
            const auto before = node.value;
            node.value = moved;
            auto scene = resolve(*copy);
            node.value = before;
            return std::get<Model>(std::move(scene.model));
          }};
}

/// A hundredth of the value, or as much less as lets `read` the scene at four times that on both sides:
/// bodies that are moved farther may overlap. Throws SceneError that names the key where there is no such
/// step.
double step_around(const scene::Document& document, const std::string& key, double value,
                   const std::function<void(double)>& read);

template <class Model>
impact::Parameter<Model> number_of_scene(const scene::Document& document, const std::string& key) {
  auto number = scene_parameter<Model>(document, key, key, expect_value(document, key));
  number.step = step_around(document, key, number.value, number.model);
  return number;
}

}  // namespace mariotte::study
