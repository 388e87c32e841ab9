// The law of Liu, Zhao & Brogliato: impulses distributed by the energies that the contacts have stored.
#pragma once
#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {

/// Parameters of the law.
struct DistributionLaw {
  std::vector<double> restitution;  ///< energetic e_j, 0 < e_j ≤ 1, one per contact
  std::vector<double> stiffness;    ///< k_j > 0, one per contact; of equal exponents only ratios matter
  std::vector<double> exponent;     ///< η_j ≥ 1, one per contact: 1 for bilinear ones, 3/2 for Hertz
  double accuracy = 1e-10;          ///< wanted error of velocities relative to the largest gap rate
  Index most_steps = 1000000;
};

/// In impulse space [Liu, Zhao & Brogliato 2008], with gap rates w and stored energies E, for equal
/// exponents:
///
///   dp_i/dp_j = (k_i/k_j)^{1/(η+1)} (E_i/E_j)^{η/(η+1)}
///   dE_j = −w_j dp_j while w_j < 0 (loading), −w_j dp_j/e_j² while w_j > 0 (unloading)
///
/// A contact ends when E_j = 0, and is loaded again when its gap closes again; the impact ends when no energy
/// is stored and no gap closes. Integrated by Dormand & Prince's method of order 5 in δ ~ E^{1/(η+1)}, with
/// dp = k δ^η dτ and dδ = −w dτ, which is the same curve without the singularity of its start, and goes on
/// where exponents differ. Every change between loading, unloading and open ends a step. Changes are seen by
/// signs at the ends of steps. Conserves momentum; loses 1 − e_j² of the energy that contact j takes up, so
/// none for e = 1. Exists for every e_j > 0. For e = 1 it is the compliant chain itself as long as no contact
/// closes twice, as in a struck row of equal balls. Where a gap opens between two periods of a contact it is
/// not: here such a contact is loaded again at once.
LawOutcome liu_zhao_brogliato(const Configuration& configuration, const DistributionLaw& law);

}  // namespace mariotte::impact
