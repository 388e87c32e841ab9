// A scene as Python holds it: with what it was made from, so that it can be made again elsewhere.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "mariotte/report/attributes.hpp"
#include "mariotte/scene/document.hpp"

namespace mariotte::python {

struct SceneBox {
  std::string text, name;  ///< TOML, and what stands for the file in messages
  scene::Overrides overrides;
  scene::Document document;
  scene::Scene scene;
  std::vector<std::string> own_laws = {};  ///< contact laws that no text can say, with their contacts
};

/// Where its numbers come from, as the command tells it, and laws that its text lacks.
report::Json provenance(const SceneBox& box);
/// The same with the text, for files that are no JSON.
report::Attributes origin(const SceneBox& box);

using SharedScene = std::shared_ptr<const SceneBox>;

}  // namespace mariotte::python
