#include "mariotte/study/sensitivity/scene_numbers.hpp"

#include "mariotte/core/nearest.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"
#include "mariotte/scene/field.hpp"
#include "mariotte/study/sensitivity/model_numbers.hpp"
#include "mariotte/study/sensitivity/scene_sizes.hpp"

namespace mariotte::study {

using scene::Document;

namespace {

constexpr double places_tried[] = {-4, -0.4, 0, 0.4, 4};  ///< in steps

/// " (did you mean 'chain.radius'?)", of the keys that the tables of a scene have.
std::string suggested_key(const Document& document, std::string_view key) {
  std::vector<std::string> known;
  for (const auto& [table, place, node] : *document.tree.table())
    if (const auto* entries = node.table())
      for (const auto& one : *entries) known.push_back(table + "." + one.key);
  return suggested_path(key.substr(0, key.find('[')),
                        std::vector<std::string_view>(known.begin(), known.end()));
}

}  // namespace

std::optional<SceneNumber> number_at(Document document, const std::string& key) {
  const auto place = add_origin(document.source, "--to " + key);
  auto& node = locate(document.source, document.tree, key, place);
  if (node.place.origin == place.origin) return std::nullopt;
  scene::ReadingLog watch{.readings = {{.node = &node}}};
  const auto scene = resolve(document, scene::Purpose::simulation, &watch);
  const auto& dimension = watch.readings[0].dimension;
  if (!dimension) return std::nullopt;
  const double value = number(document.source, {&node, key}, *dimension, scene::Domain::any);
  return SceneNumber{value, value == 0 ? typical(scene, *dimension) : std::abs(value), *dimension};
}

std::vector<std::string> elements_of(Document document, const std::string& key) {
  const auto place = add_origin(document.source, "--to " + key);
  const auto* list = locate(document.source, document.tree, key, place).array();
  if (!list || list->empty()) return {key};
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < list->size(); ++i) keys.push_back(key + "[" + std::to_string(i) + "]");
  return keys;
}

SceneNumber expect_number(const Document& document, const std::string& key) {
  const auto found = number_at(document, key);
  if (found && std::isfinite(found->value)) return *found;
  Document copy = document;
  const auto place = add_origin(copy.source, "--to " + key);
  reject(copy.source, place, fault::leads_nowhere,
         "is no finite number of the model or the scene" + suggested_key(document, key));
}

double step_around(Document document, const std::string& key, const SceneNumber& number) {
  const auto place = add_origin(document.source, "--to " + key);
  auto& node = locate(document.source, document.tree, key, place);
  std::optional<scene::SceneError> why;
  for (const double share : {impact::stencil_share, 1e-3, 1e-4, 1e-5, 1e-6}) try {
      std::vector<ModelNumber> at[5];
      for (int i = 0; i < 5; ++i) {
        node.value = number.value + places_tried[i] * share * number.size;
        at[i] = model_numbers(resolve(document));
      }
      if (is_smooth(at)) return share * number.size;
    } catch (const scene::SceneError& error) {
      why = error;
    }
  if (!why)
    reject(document.source, place, fault::leads_nowhere,
           "has no slope: what the scene makes of it bends or jumps at this value");
  reject(document.source, place, why->fault,
         std::string("has no slope, since the scene ends next to it: ") + why->what());
}

bool is_time_limit(const Document& document, const std::string& key) {
  if (key != "run.until" && key != "run.max_time") return false;
  const auto number = number_at(document, key);
  return number && number->value == resolve(document).run.max_time;
}

bool is_asked_for(const std::string& name, const std::string& key) {
  return name.starts_with(key) &&
         (name.size() == key.size() || name[key.size()] == '[' || name[key.size()] == '.');
}

}  // namespace mariotte::study
