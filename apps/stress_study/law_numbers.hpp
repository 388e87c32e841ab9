// Laws that scenes name, as lists of numbers.
#pragma once
#include <algorithm>

#include "mariotte/contact/named_laws.hpp"

namespace mariotte::stress_study {

/// A law by its name.
inline const contact::NamedLaw& named_law(std::string_view name) {
  return *std::find_if(contact::named_laws.begin(), contact::named_laws.end(),
                       [&](const contact::NamedLaw& one) { return one.name == name; });
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
  return named.make(numbers);
}

}  // namespace mariotte::stress_study
