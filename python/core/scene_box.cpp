#include "scene_box.hpp"

#include <nlohmann/json.hpp>

#include "mariotte/report/json/json_parts.hpp"

namespace mariotte::python {

report::Json provenance(const SceneBox& box) {
  auto all = report::provenance_json(box.scene.sha256);
  all["scene"] = box.name;
  all["overrides"] = box.overrides;
  if (box.own_laws.empty()) return all;
  all.erase("scene_sha256");
  all["own_laws"] = box.own_laws;
  return all;
}

report::Attributes origin(const SceneBox& box) {
  auto all = report::attributes(provenance(box));
  all.emplace_back("scene_text", box.text);
  return all;
}

}  // namespace mariotte::python
