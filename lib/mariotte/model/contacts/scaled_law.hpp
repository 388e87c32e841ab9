// What making a chain or a network dimensionless has in common.
#pragma once
#include "mariotte/contact/law.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::model {

/// k L^{n+1}/(M V²) and c L^n/(M V) of a power law. One with the reference's exponent divides by its
/// stiffness instead of going through L, which makes the reference's own stiffness exactly 1. Any other law
/// is asked in its own units.
contact::Law scaled(const contact::Law& law, const Scale& scale, const contact::Law& reference);

/// The indentation L of a contact that a mass strikes at a speed: k L^{n+1} = m v² of a power law, and where
/// any other law stores m v²/2. Throws InvalidParameter if it never does.
class NaturalLength {
 public:
  double operator()(const contact::Law& law, double mass, double speed);

 private:
  double q_ = 0, exponent_ = 0, length_ = 0;  ///< of the last answer: contacts of a model are mostly alike
};

/// Stiffness, damping and exponent as the flows see them; a law that is no power law is no force at all, for
/// they follow such a contact while it is open only.
contact::PowerLaw seen_by_flows(const contact::Law& law);

/// Approach that counts as none, relative to the largest: a tenth of the accuracy, but what double precision
/// can tell.
double slow_share(double accuracy);

/// Damping ratio c δⁿ⁻¹ T/m* of contact j at its natural indentation δ, or (∂f/∂δ̇) T/m* of any law: what
/// makes it stiff. `scaled` is a dimensionless chain or network.
template <class Scaled>
double damping_ratio(const Scaled& scaled, std::size_t j) {
  if (!contact::dissipates(scaled.law[j])) return 0;
  const double slope = contact::smooth_force(scaled.law[j], scaled.length[j], 0).by_rate;
  return slope * scaled.time[j] / scaled.reduced_mass[j];
}

}  // namespace mariotte::model
