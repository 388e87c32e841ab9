// The numbers of a resolved scene, one after the other.
#pragma once
#include <vector>

#include "mariotte/scene/scene.hpp"

namespace mariotte::study {

/// Pointers to all numbers of a chain's scene that a sweep can set, in an order that depends on its form
/// alone; none for other kinds of scenes, or of
/// laws. They hold while the scene is not assigned to.
std::vector<double*> numbers(scene::Scene& scene);

/// Whether two scenes of a chain differ in such numbers only; false of other kinds.
bool same_form(const scene::Scene& a, const scene::Scene& b);

}  // namespace mariotte::study
