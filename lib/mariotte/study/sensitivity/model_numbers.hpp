// All numbers of a model in one list, to see how they move with a number of its scene.
#pragma once
#include <vector>

#include "mariotte/scene/scene.hpp"

namespace mariotte::study {

/// A number, and what rounding of those that it follows from may make of it.
struct ModelNumber {
  double value;
  double rounding = 0;
};

/// Masses, places, directions, velocities and numbers of laws. Lists of two models that touch in other places
/// differ in length, or in the places that networks push.
std::vector<ModelNumber> model_numbers(const scene::Scene& scene);

/// Whether a number moves smoothly from −h to h, as lists at −h, −h/10, 0, h/10 and h tell: its second
/// difference grows with the square of the distance, and hardly faster. Where it bends at once the difference
/// grows with the distance, or begins on the way.
bool is_smooth(const std::vector<ModelNumber> (&at)[5]);

}  // namespace mariotte::study
