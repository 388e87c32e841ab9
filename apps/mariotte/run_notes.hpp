// What a run says on stderr of its ending.
#pragma once
#include <string>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::command {

/// Why a run ended early. A time limit and an interruption are the user's own wish, and only warned of.
void tell_ending(hybrid::Ending ending, const std::string& message, const scene::Scene& scene);

}  // namespace mariotte::command
