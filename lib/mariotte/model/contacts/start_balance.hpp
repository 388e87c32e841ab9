// Contacts that are indented at the start give their energy back only as far as their forces do not balance.
#pragma once
#include <vector>

#include "mariotte/model/contacts/scaled_contacts.hpp"

namespace mariotte::model {

/// f(δ) of each contact at the start, at rest; 0 of open ones.
std::vector<double> start_forces(const StatedContacts& stated);

/// Sum of the squares of speeds with which contacts begin to vibrate that are indented at the start and
/// accelerate together by `approach`: (a/ω)² with ω² = (∂f/∂δ)/m. Infinite unless all are near balance.
double unbalanced_speeds(const StatedContacts& stated, const std::vector<double>& reduced_mass,
                         const std::vector<double>& approach);

}  // namespace mariotte::model
