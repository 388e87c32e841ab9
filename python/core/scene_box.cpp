#include "scene_box.hpp"

#include <nlohmann/json.hpp>

#include "mariotte/report/json/json_parts.hpp"

namespace mariotte::python {

report::Attributes origin(const SceneBox& box) {
  auto all = report::provenance_json(box.scene.sha256);
  all["scene"] = box.name;
  all["overrides"] = box.overrides;
  return report::attributes(all);
}

}  // namespace mariotte::python
