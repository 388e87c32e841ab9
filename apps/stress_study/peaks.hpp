// Largest forces of elastic contacts are what their laws give at the largest indentations.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/contact/law.hpp"

namespace mariotte::stress_study {

/// How far they are from that at most, relative to the largest force of all; `law_of(j)` is that of place j.
template <class Contacts, class LawOf>
double peak_misfit(const Contacts& contacts, LawOf&& law_of) {
  double largest = 0, misfit = 0;
  for (std::size_t j = 0; j < contacts.size(); ++j) {
    const auto& one = contacts[j];
    largest = std::max(largest, one.peak_force);
    const contact::Law any = law_of(j);
    const auto* law = contact::power_law(any);
    if (!law || law->damping > 0 || !(one.peak_indentation > 0)) continue;
    const double force = law->stiffness * std::pow(one.peak_indentation, law->exponent);
    misfit = std::max(misfit, std::abs(one.peak_force - force));
  }
  return largest > 0 ? misfit / largest : 0;
}

}  // namespace mariotte::stress_study
