// How far a contact may be loaded before what its law leaves out matters.
#pragma once
#include <cmath>
#include <numbers>

#include "mariotte/contact/brach_dunn.hpp"

namespace mariotte::contact {

/// E* [Pa] of a Hertz contact, k = (4/3) E* √R [N/m^{3/2}] [Johnson 1985, §4.2].
inline double contact_modulus(double stiffness, double radius) {
  return 0.75 * stiffness / std::sqrt(radius);
}

/// The other way round.
inline double contact_stiffness(double modulus, double radius) {
  return 4.0 / 3 * modulus * std::sqrt(radius);
}

/// p₀ = (2/π) E* √(δ/R) [Pa], in the middle of a Hertz contact [Johnson 1985, §4.2].
inline double peak_pressure(double modulus, double radius, double indentation) {
  return 2 / std::numbers::pi * modulus * std::sqrt(indentation / radius);
}

/// p₀/Y at which a sphere first yields, below its surface, for ν = 0.3 [Johnson 1985, §6.1].
inline constexpr double first_yield = 1.60;

/// Speed at which two bodies of reduced mass m, alone, reach the pressure p₀:
/// v = (π/2E*)² √(8πR³/15m) p₀^{5/2} [m/s] [Davies 1949; Johnson 1985, §11.5].
inline double speed_of_pressure(double modulus, double radius, double mass, double pressure) {
  const double strain = std::numbers::pi * pressure / (2 * modulus);
  return strain * strain * std::sqrt(16 * modulus * strain * radius * radius * radius / (15 * mass));
}

/// Time of a wave through a ball and back, 4R/c with c = √(E/ρ) [s].
inline double wave_travel(double radius, double density, double young) {
  return 4 * radius * std::sqrt(density / young);
}

/// Distance of atoms at rest [m]: how far adhesion reaches.
inline constexpr double reach_of_adhesion = 0.4e-9;

/// μ = (R w²/(E*² z₀³))^{1/3}, how far adhesion deforms a contact over how far it reaches [Tabor 1977]. A
/// ring of force on the edge of the contact belongs to large μ, as does the law of Johnson, Kendall &
/// Roberts.
inline double tabor_number(double modulus, double radius, double work) {
  return std::cbrt(radius * work * work / (modulus * modulus)) / reach_of_adhesion;
}
inline double tabor_number(const BrachDunn& law, double radius) {
  const double stiffness = law.stiffness / std::sqrt(radius);
  const double line = law.adhesion / (2 * std::numbers::pi * std::sqrt(radius));
  const double work_squared = 2 * std::numbers::pi * line * line * line / (9 * stiffness * radius);
  return tabor_number(0.75 * stiffness, radius, std::sqrt(work_squared));
}

/// ζ of small oscillations about the indentation at which the tip rests in the well; ≥ 1 creeps.
inline double well_damping(const BrachDunn& law, double mass) {
  const double width = std::sqrt(rest_indentation(law));
  const double slope = width * law.stiffness;
  const double damping = width * law.adhesion * (law.damping_hertz + law.damping_adhesion);
  return damping / (2 * std::sqrt(slope * mass));
}

}  // namespace mariotte::contact
