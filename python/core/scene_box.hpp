// A scene as Python holds it: with what it was made from, so that it can be made again elsewhere.
#pragma once
#include <memory>
#include <string>

#include "mariotte/report/attributes.hpp"
#include "mariotte/scene/document.hpp"

namespace mariotte::python {

struct SceneBox {
  std::string text, name;  ///< TOML, and what stands for the file in messages
  scene::Overrides overrides;
  scene::Document document;
  scene::Scene scene;
  bool foreign = false;  ///< has contact laws that no text can say
};

/// Where files of its numbers come from, as those of the command tell it.
report::Attributes origin(const SceneBox& box);

using SharedScene = std::shared_ptr<const SceneBox>;

}  // namespace mariotte::python
