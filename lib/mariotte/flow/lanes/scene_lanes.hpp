// Scenes side by side: one in each lane of a register.
#pragma once
#include <span>

#include "mariotte/flow/taylor/taylor_stepper.hpp"

namespace mariotte::flow {

/// What a scene becomes does not depend on those beside it: a lane knows nothing of the others.
template <class Scene>
class SceneLanes {
 public:
  virtual ~SceneLanes() = default;
  /// From where contacts push until all is over, or another solver has to tell. A lane whose scene has come
  /// to that takes the next one.
  virtual void follow(std::span<Scene* const> scenes, const taylor::Precision& precision) = 0;
};

}  // namespace mariotte::flow
