// A restitution without a speed for which it holds.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/document.hpp"

namespace mariotte::study {

/// Whether a key says how fast something moves at the start.
bool is_speed(const std::string& key);

/// A warning if the scene says a restitution, and its damping is another one in the second of two scenes,
/// which differ in speed alone: then e is the same at all speeds. Empty if not.
std::vector<std::string> warn_of_constant_restitution(const scene::Document& document,
                                                      const scene::Scene& slow, const scene::Scene& fast);

}  // namespace mariotte::study
