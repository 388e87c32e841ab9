// What is known of bodies that touch, for the validity of a run.
#pragma once
#include <span>

#include "mariotte/impact/validity.hpp"
#include "mariotte/scene/balls.hpp"

namespace mariotte::scene {

/// Of two balls with masses; a plane has an infinite radius. Nothing unless both radii are known.
impact::Touching touching(const Ball& left, const Ball& right);

/// Of each ball and the next; empty if nothing is known of any.
std::vector<impact::Touching> touching(std::span<const Ball> balls);

}  // namespace mariotte::scene
