// The word for a contact law, as scenes spell it.
#pragma once
#include "mariotte/contact/law.hpp"

namespace mariotte::report {

/// "linear", "hertz" or "viscoelastic".
inline const char* law_name(const contact::Law& law) {
  if (std::holds_alternative<contact::Linear>(law)) return "linear";
  return std::holds_alternative<contact::Hertz>(law) ? "hertz" : "viscoelastic";
}

}  // namespace mariotte::report
