// Coefficients of restitution: of velocities, of a body that strikes a plane [Cheng 2002], and of energy.
#pragma once
#include <optional>

namespace mariotte::impact {

/// Rebound over incident normal velocity; both 0 of a captured body.
struct Restitution {
  double tip = 0;     ///< e_n, of the tip that touched first
  double centre = 0;  ///< e_nm, of the mass centre; negative if it goes on towards the plane
};

/// From normal velocities along e1, before and after.
inline Restitution restitution(double tip_in, double tip_out, double centre_in, double centre_out) {
  return {.tip = -tip_out / tip_in, .centre = -centre_out / centre_in};
}

/// T⁺/T⁻, kinetic energies after and before an impact; empty where nothing moved before.
inline std::optional<double> energy_ratio(double after, double before) {
  return before > 0 ? std::optional(after / before) : std::nullopt;
}

}  // namespace mariotte::impact
