// Laws and friction of the contacts of random bodies, as lines of a scene.
#pragma once
#include <string>

#include "dice.hpp"

namespace mariotte::stress_study {

inline constexpr double ball_radius = 0.01, ball_mass = 0.03, ball_speed = 1;

/// What holds for every contact: sizes follow from how deep a ball would indent at the speed of the scene.
struct Contacts {
  double depth, time;  ///< natural ones
  std::string text;
};

/// What contacts may do: stick without a spring, hold bodies together, and damp beyond what is critical.
struct Allowed {
  bool rigid = true, adhesion = true, overdamped = true;
};

Contacts some_contacts(Dice& dice, const Allowed& allowed = {});

}  // namespace mariotte::stress_study
