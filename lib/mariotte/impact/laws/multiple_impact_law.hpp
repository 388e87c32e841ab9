// The multiple-impact law: velocities after an impact from those before, the direction of the impulses and
// the energy ratio, in one step [Acary 2003, Appendix A, corrected; theory page, "The multiple-impact law"].
//
//   p = P r,   v⁺ = v + M⁻¹ Gᵀ p,   A P² − 2 B P + (1 − e) S = 0,   P = (B + √(B² − A (1 − e) S)) / A
//   A = rᵀ G M⁻¹ Gᵀ r,   B = −rᵀ G v,   S = vᵀ M v
//
// Of the two roots the larger is taken: an admissible outcome has p · w⁺ ≥ 0 with gap rates w⁺ = G v⁺.
#pragma once
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/laws/law_outcome.hpp"

namespace mariotte::impact {

/// The kinetic energy that e compares.
enum class EnergyFrame {
  given,       ///< in the frame of the given velocities; e changes with that frame
  mass_centre  ///< relative_energy: the part that impulses can change; e does not change with the frame
};

/// What the law needs beside the configuration.
struct LawParameters {
  std::vector<double> direction;  ///< r, one value per contact; its length does not matter
  double energy_ratio = 1;        ///< e = T⁺/T⁻ ≥ 0
  EnergyFrame frame = EnergyFrame::given;
  double slow = rounding;  ///< approach, relative to the largest gap rate, that counts as none
};

/// Apply the law. Throws InvalidParameter for input that makes no sense, among it a moving wall where e
/// compares energies in the given frame.
LawOutcome multiple_impact(const Configuration& configuration, const LawParameters& parameters);

/// Impulse direction of n balls from n−2 ratios α_j = p_j/p_{j+1}: r_{n−1} = 1, r_j = α_j r_{j+1}.
/// Throws InvalidParameter if a ratio is not finite.
std::vector<double> direction_of_ratios(const std::vector<double>& icr);

/// The inverse: the parameters with which the law gives these impulses and velocities.
LawParameters parameters_of(const Configuration& before, const std::vector<double>& impulse,
                            const std::vector<double>& velocity_after,
                            EnergyFrame frame = EnergyFrame::given);

/// Of a simulated impact. Throws InvalidParameter where the energy ratio is not defined in that frame.
LawParameters parameters_of(const ContactImpact& impact, EnergyFrame frame = EnergyFrame::given);

}  // namespace mariotte::impact
