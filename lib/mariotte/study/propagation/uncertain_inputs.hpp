// Numbers of a scene that are known to a standard deviation: "10 mm ± 1 um", "0.3 +- 0.01", "2 GPa ± 5 %".
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/document.hpp"

namespace mariotte::study {

/// A key of the scene with the value and the standard deviation of its number [SI].
struct UncertainInput {
  std::string key;
  scene::Place place;
  double value, deviation;
};

/// Leaves the values alone in the document and returns what was uncertain, in the order of the file. Throws
/// SceneError for a deviation that is no positive quantity of the dimension of its value, for a value of
/// zero, which has slopes on one side, and for what the scene does not read as a number.
std::vector<UncertainInput> take_uncertain_inputs(scene::Document& document);

}  // namespace mariotte::study
