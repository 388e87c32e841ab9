// A system at the instant of an impact, as impact laws see it: masses, contact directions, velocities.
#pragma once
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/model/network/mass_matrix.hpp"

namespace mariotte::impact {

/// n degrees of freedom with mass matrix M, m contacts with gap rates w = G v [theory page, "The
/// multiple-impact law"]. Any consistent units.
struct Configuration {
  model::MassMatrix mass;                 ///< M
  std::vector<ContactDirection> contact;  ///< G, m rows
  std::vector<double> velocity;           ///< v⁻, n values
};

/// Balls on a line from left to right, n masses (∞ for a wall) and velocities; contact j joins j and j+1.
Configuration chain_configuration(std::vector<double> mass, std::vector<double> velocity);

/// Throws InvalidParameter unless sizes match, velocities and coefficients are finite, M is positive, and no
/// energy m v² at the largest speed leaves the sizes that are computed with (model/representable.hpp).
void validate(const Configuration& configuration);

/// G v of any velocities, m values; negative where a gap closes.
std::vector<double> gap_rates(const Configuration& configuration, const std::vector<double>& velocity);

/// Gᵀ p, the n generalised impulses of m contact impulses.
std::vector<double> generalised_impulse(const Configuration& configuration, const std::vector<double>& p);

/// M⁻¹ Gᵀ p, by which the velocities change.
std::vector<double> velocity_change(const Configuration& configuration, const std::vector<double>& p);

/// G M⁻¹ Gᵀ, m² values: how the gap rates answer to impulses (the Delassus matrix).
std::vector<double> compliance(const Configuration& configuration);

/// ½ vᵀ M v of any velocities. Walls do not count.
double kinetic_energy(const Configuration& configuration, const std::vector<double>& velocity);

/// ½ wᵀ (G M⁻¹ Gᵀ)⁺ w: the part of the kinetic energy that impulses at the contacts can change, the least
/// with these gap rates. For a chain without walls it is the kinetic energy relative to the mass centre, with
/// walls at rest all of it. Where walls squeeze what touches, no velocities have these rates; those of the
/// nearest rates count, each rate over that of a unit impulse.
double relative_energy(const Configuration& configuration, const std::vector<double>& velocity);
/// Those of several velocities, for little more than one.
std::vector<double> relative_energies(const Configuration& configuration,
                                      const std::vector<std::vector<double>>& velocities);

}  // namespace mariotte::impact
