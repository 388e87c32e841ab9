// What tables call a law.
#pragma once
#include <string>

#include "mariotte/contact/law.hpp"

namespace mariotte::report {

/// Its name and, where its exponent has a name of its own, that as well: "viscoelastic (kelvin-voigt)".
std::string law_name(const contact::Law& law);

}  // namespace mariotte::report
