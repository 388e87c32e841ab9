// What every impact law returns: impulses, velocities, and whether they make sense.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/impact/laws/configuration.hpp"

namespace mariotte::impact {

/// Whether an outcome makes sense, or why not.
enum class LawStatus {
  admissible,
  tensile_impulse,       ///< a contact would pull
  penetrating_velocity,  ///< a contact would go on closing
  complex,               ///< e is below `least_energy_ratio`: nothing satisfies the energy balance
  no_impact,             ///< along the impulse direction nothing approaches; velocities stay
  unfinished             ///< a limit of collisions or steps was reached; what was computed until then
};

/// Impulses and velocities, and what is known of them.
struct LawOutcome {
  LawStatus status = LawStatus::no_impact;
  std::optional<Index> contact = {};              ///< the first that pulls or goes on closing, from 0
  std::vector<double> impulse = {};               ///< p, one value per contact; empty if complex
  std::vector<double> velocity = {};              ///< v⁺, n values; empty if complex
  std::optional<double> least_energy_ratio = {};  ///< of the multiple-impact law: 1 − B²/(A S)
  std::optional<double> ratio_lab = {};           ///< T⁺/T⁻ in the given frame; empty if T⁻ = 0
  std::optional<double> ratio_centre = {};        ///< the same of the relative energy
  Index steps = 0;                                ///< collisions or steps of laws that take them
};

/// Gap rates of an outcome carry the rounding of velocities and impulses, times the number of contacts.
inline constexpr double rounding = 1e-12;

/// The outcome of these impulses. An approach of less than `slow` times the largest gap rate, before or
/// after, counts as none.
LawOutcome outcome_of(const Configuration& configuration, std::vector<double> impulse,
                      double slow = rounding);

/// Throws InvalidParameter unless the configuration makes sense and there is one coefficient of restitution,
/// 0 ≤ e ≤ 1, per contact.
void validate(const Configuration& configuration, const std::vector<double>& restitution);

/// Throws InvalidParameter unless a direction of impulses has one finite value per contact.
void validate_direction(const Configuration& configuration, const std::vector<double>& direction);

/// "admissible", "tensile_impulse", "penetrating_velocity", "complex", "no_impact", "unfinished".
const char* name(LawStatus status);

/// Why an outcome is not admissible, a sentence in which contacts count from 1; empty if it is.
std::string reason(const LawOutcome& outcome);

}  // namespace mariotte::impact
