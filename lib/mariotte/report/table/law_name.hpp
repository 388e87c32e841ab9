// What tables say of a law.
#pragma once
#include <functional>
#include <string>

#include "mariotte/contact/law.hpp"

namespace mariotte::report {

/// Its name and, where its exponent has a name of its own, that as well: "viscoelastic (kelvin-voigt)".
std::string law_name(const contact::Law& law);

/// Its numbers by column; empty where it has none. Damping that is not c of a power law stands with the
/// others, since its unit is another, and what is said in words does, too.
struct LawCells {
  std::string stiffness, damping, exponent, others;
};
LawCells law_cells(const contact::Law& law, const std::function<std::string(double)>& number);

}  // namespace mariotte::report
