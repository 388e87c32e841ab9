// Natural modes of undamped springs.
#pragma once
#include <span>
#include <vector>

#include "mariotte/flow/linked_phase.hpp"

namespace mariotte::flow {

/// With z = √K δ the contacts obey z̈ = −C Cᵀ z, C = √K G L⁻ᵀ, M = L Lᵀ: the generalised eigenproblem
/// Gᵀ K G u = ω² M u, seen from the contacts. The singular values of C are the natural frequencies; taking
/// them from C, not from C Cᵀ, by rotations that respect the grading of its rows keeps the low ones exact
/// beside contacts 10^10 times as stiff [Demmel & Veselić 1992].
struct NaturalModes {
  std::vector<double>
      frequency;              ///< one per contact; rounding noise for the one that a wall at each end fixes
  std::vector<double> shape;  ///< orthogonal: column i is mode i in terms of z
  std::vector<double> coupling;  ///< workspace

  double at(Index contact, Index mode) const {
    return shape[static_cast<Index>(frequency.size()) * mode + contact];
  }
};

/// n+1 bodies, zero inverse mass for walls, joined by n springs.
void find(NaturalModes& modes, std::span<const double> inverse_mass, std::span<const double> stiffness);

/// The closed contacts of a phase; zero frequencies where they move nothing.
void find(NaturalModes& modes, const LinkedPhase& phase, std::span<const Index> closed);

}  // namespace mariotte::flow
