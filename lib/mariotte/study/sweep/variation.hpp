// The scene of every point of a design, at the price of a few stores where that is possible.
//
// A key is direct if its value stands unchanged in some numbers of the resolved scene, and changes nothing
// else: a velocity does, a radius that decides masses and stiffnesses does not. If all keys of a design are
// direct the scene is resolved once and numbers are set in it; else every point is resolved from the tree.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::study {

/// Which numbers of a scene each parameter sets, by their position among all its numbers.
using Slots = std::vector<std::vector<std::size_t>>;

/// The slots of a design whose keys are all direct; empty otherwise, and of one with so few points that to
/// find them would take longer than to read every point. Each parameter is moved alone, to up to 64 of its
/// values: what follows it there, and nothing else may move, is its slot. Then up to 64 points of the whole
/// grid are compared with what the reader makes of them.
std::optional<Slots> find_slots(const scene::Document& document, const Design& design);

/// Goes from point to point. Not to be shared between threads; each has its own.
class Variation {
 public:
  /// Without slots every point is resolved. Expressions of the design are copied, too, as each thread needs.
  Variation(scene::Document document, const Design& design, const std::optional<Slots>& slots);
  Variation(const Variation&) = delete;
  Variation& operator=(const Variation&) = delete;

  /// The scene of a point; holds until the next call. Throws SceneError.
  const scene::Scene& at(Index point);
  /// What it is read from; holds until the next call.
  const scene::Document& document(Index point);

 private:
  scene::Document document_;
  Design design_;
  scene::Scene scene_;
  std::vector<std::vector<double*>> numbers_;  ///< that each parameter sets; empty if points are resolved
};

}  // namespace mariotte::study
