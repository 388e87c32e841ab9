// The laws that scenes can name: the one list that the reader, its messages and the pages follow.
#pragma once
#include <optional>
#include <string>

#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/law.hpp"
#include "mariotte/core/dimension.hpp"

namespace mariotte::contact {

/// A law with a stiffness k [N/m^n] and an exponent n, and perhaps a damping. Laws of one's own are handed to
/// models in C++, and need no entry.
struct NamedLaw {
  std::string_view name;                            ///< as scenes and results spell it
  std::string_view force;                           ///< formula
  std::optional<double> exponent;                   ///< its own; scenes choose n ≥ 1 if there is none
  Dimension (*damping)(double exponent) = nullptr;  ///< of the damping it needs; null if it has none
  std::string_view damping_unit = {};
  Law (*make)(double stiffness, double damping, double exponent);
};

inline constexpr NamedLaw named_laws[] = {
    {.name = "linear",
     .force = "k δ",
     .exponent = 1,
     .make = [](double k, double, double) -> Law { return Linear(k); }},
    {.name = "hertz",
     .force = "k δ^{3/2}",
     .exponent = 1.5,
     .make = [](double k, double, double) -> Law { return Hertz(k); }},
    {.name = "viscoelastic",
     .force = "max(0, k δⁿ + c δⁿ⁻¹ δ̇)",
     .exponent = {},
     .damping = dimension::damping,
     .damping_unit = "N s/m^n",
     .make = [](double k, double c, double n) -> Law {
       return PowerLaw{k, c, n};
     }},
    {.name = "hunt-crossley",
     .force = "max(0, k δⁿ (1 + a δ̇))",
     .exponent = {},
     .damping = [](double) { return Dimension{.m = -1, .s = 1}; },
     .damping_unit = "s/m",
     .make = [](double k, double a, double n) -> Law { return std::make_shared<HuntCrossley>(k, a, n); }},
};

/// "linear, hertz or viscoelastic": all names, for messages.
std::string names_of_laws();

}  // namespace mariotte::contact
