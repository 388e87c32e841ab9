// Parts that every JSON result is made of.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "mariotte/report/json/json.hpp"
#include "mariotte/scene/node.hpp"

namespace mariotte::report {

inline Json nullable(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class Values, class Write>
Json list(const Values& values, const Write& write) {
  Json array = Json::array();
  for (const auto& value : values) array.push_back(write(value));
  return array;
}

/// A value of a scene; null for an array or a table.
Json json_of_value(const scene::Node& node);

Json options(const hybrid::Options& run);

/// What computed the result, and of which scene; null where there was none.
Json provenance_json(const std::string& scene_sha256);

/// The scene of a body as it was understood.
Json json_of_body(const model::Microbody& body, const scene::Scene& scene);
/// The scene of bodies as it was understood.
Json json_of_bodies(const model::Bodies& bodies, const scene::Scene& scene);

/// A law by its name and numbers.
Json law_json(const contact::Law& law);

}  // namespace mariotte::report
