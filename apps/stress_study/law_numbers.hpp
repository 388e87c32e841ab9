// Laws that scenes name, as lists of numbers.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mariotte/contact/named_laws.hpp"

namespace mariotte::stress_study {

/// A law by its name.
inline const contact::NamedLaw& named_law(std::string_view name) {
  return *std::find_if(contact::named_laws.begin(), contact::named_laws.end(),
                       [&](const contact::NamedLaw& one) { return one.name == name; });
}

/// Pressure above which a contact that yields and adheres has passed its snap-in: one that yields at contact
/// radii below (5/4 s R)^{2/3}, s² = 2πw/E*, gains energy.
inline double least_yield_pressure(const contact::LawNumbers& numbers) {
  using std::numbers::pi;
  const double e = numbers.effective_modulus, r = numbers.effective_radius, w = numbers.work_of_adhesion;
  const double snap = std::cbrt(2 * pi * w * r * r / e * 25 / 16);
  return std::max(0.0, 2 * e * snap / (pi * r) - std::sqrt(2 * w * e / (pi * snap)));
}

/// The same law after `change(key, value)` of each of its numbers.
template <class Change>
contact::Law with_numbers(const contact::Law& law, Change&& change) {
  const auto& named = named_law(name(law));
  contact::LawNumbers numbers;
  for (auto [key, value] : contact::parameters(law)) {
    change(key, value);
    numbers.*named.find(key)->number = value;
  }
  return contact::is_uncut(law) ? contact::uncut(named.make(numbers)) : named.make(numbers);
}

}  // namespace mariotte::stress_study
