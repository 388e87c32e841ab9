#include "mariotte/study/sensitivity/scene_numbers.hpp"

#include "mariotte/scene/field.hpp"

namespace mariotte::study {

using scene::Document;

std::optional<double> value_of(Document document, const std::string& key) {
  const auto place = add_origin(document.source, "--to " + key);
  auto& node = locate(document.source, document.tree, key, place);
  if (node.place.origin == place.origin) return std::nullopt;
  scene::ReadingLog watch{.readings = {{.node = &node}}};
  resolve(document, scene::Purpose::simulation, &watch);
  if (!watch.readings[0].dimension) return std::nullopt;
  return number(document.source, {&node, key}, *watch.readings[0].dimension, scene::Domain::any);
}

double expect_value(const Document& document, const std::string& key) {
  const auto value = value_of(document, key);
  if (value && *value != 0 && std::isfinite(*value)) return *value;
  Document copy = document;
  const auto place = add_origin(copy.source, "--to " + key);
  reject(copy.source, place, fault::leads_nowhere,
         "is no number of the model or the scene that has a value other than zero");
}

double step_around(const Document& document, const std::string& key, double value,
                   const std::function<void(double)>& read) {
  std::optional<scene::SceneError> why;
  for (const double share : {1e-2, 1e-3, 1e-4, 1e-5}) try {
      const double step = share * std::abs(value);
      read(value - 4 * step);
      read(value + 4 * step);
      return step;
    } catch (const scene::SceneError& error) {
      why = error;
    }
  Document copy = document;
  const auto place = add_origin(copy.source, "--to " + key);
  reject(copy.source, place, why->fault,
         std::string("has no slope, since the scene ends next to it: ") + why->what());
}

bool is_asked_for(const std::string& name, const std::string& key) {
  return name.starts_with(key) &&
         (name.size() == key.size() || name[key.size()] == '[' || name[key.size()] == '.');
}

}  // namespace mariotte::study
