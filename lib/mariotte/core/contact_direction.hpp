// How a contact's gap follows the velocities of a system with any degrees of freedom.
#pragma once
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte {

/// One coefficient of a contact direction.
struct Term {
  Index dof;
  double coefficient;
};

/// A row of G: the rate of the contact's gap is Σ coefficient · velocity of that dof.
using ContactDirection = std::vector<Term>;

/// G v of one contact.
inline double gap_rate(const ContactDirection& contact, ConstState velocity) {
  double rate = 0;
  for (const auto& [dof, coefficient] : contact) rate += coefficient * velocity[dof];
  return rate;
}

/// Σ of the products of coefficients of the same dof; with a column of M⁻¹ Gᵀ, an entry of G M⁻¹ Gᵀ.
inline double dot(const ContactDirection& contact, const ContactDirection& other) {
  double sum = 0;
  for (const auto& [dof, coefficient] : contact)
    for (const auto& term : other)
      if (dof == term.dof) sum += coefficient * term.coefficient;
  return sum;
}

}  // namespace mariotte
