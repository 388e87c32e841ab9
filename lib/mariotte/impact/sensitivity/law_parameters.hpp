// The numbers of a contact law as parameters.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/dimension.hpp"

namespace mariotte::impact {

/// A number of a law that the law can be made again with.
struct LawParameterChoice {
  std::string key;
  double value;
  double step;
  std::function<contact::Law(double)> law;
  Dimension dimension;
  bool is_linear;  ///< forces are
};

/// All that have slopes on both sides: a damping of 0, an exponent of 1 and stiffnesses of loading and
/// unloading that are equal have none, and the exponent of a linear or a Hertz contact is not chosen. Empty
/// for laws that are not named.
std::vector<LawParameterChoice> law_parameters(const contact::Law& law);

}  // namespace mariotte::impact
