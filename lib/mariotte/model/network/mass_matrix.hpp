// Masses and contact directions of a system with any degrees of freedom.
#pragma once
#include <vector>

#include "mariotte/core/contact_direction.hpp"

namespace mariotte::model {

/// M of n dofs: its diagonal (n values, ∞ for a wall) or all n², by rows.
using MassMatrix = std::vector<double>;

/// True if only the diagonal is given.
inline bool is_diagonal(const MassMatrix& mass, Index dofs) {
  return std::ssize(mass) == dofs;
}

/// Throws InvalidParameter unless the mass matrix is one of n dofs, symmetric and positive, and every
/// direction names existing dofs, is finite and can move something.
void validate(const MassMatrix& mass, const std::vector<ContactDirection>& contact, Index dofs);

/// M⁻¹ y.
std::vector<double> solve(const MassMatrix& mass, std::vector<double> y);

/// Columns of M⁻¹ Gᵀ: how each contact's impulse changes the velocities. Zeros are left out.
std::vector<ContactDirection> responses(const MassMatrix& mass, const std::vector<ContactDirection>& contact,
                                        Index dofs);
/// The same into `columns`, whose memory is reused.
void responses(const MassMatrix& mass, const std::vector<ContactDirection>& contact, Index dofs,
               std::vector<ContactDirection>& columns);

/// Columns of L⁻¹ Gᵀ with M = L Lᵀ: half of the way there. Zeros are left out; memory is reused.
void half_responses(const MassMatrix& mass, const std::vector<ContactDirection>& contact, Index dofs,
                    std::vector<ContactDirection>& columns);

}  // namespace mariotte::model
