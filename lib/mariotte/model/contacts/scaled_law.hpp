// What making a chain or a network dimensionless has in common.
#pragma once
#include <cmath>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::model {

/// k L^{n+1}/(M V²) and c L^n/(M V). Contacts with the reference's exponent divide by its stiffness instead
/// of going through L, which makes the reference's own stiffness exactly 1.
contact::Law scaled(const contact::Law& law, const Scale& scale, const contact::Law& reference);

/// The indentation L with k L^{n+1} = m v².
double natural_length(const contact::Law& law, double mass, double speed);

/// Approach that counts as none, relative to the largest: a tenth of the accuracy, but what double precision
/// can tell.
double slow_share(double accuracy);

/// Damping ratio c δⁿ⁻¹ T/m* of contact j at its natural indentation δ: what makes it stiff. `scaled` is a
/// dimensionless chain or network.
template <class Scaled>
double damping_ratio(const Scaled& scaled, std::size_t j) {
  const auto& law = scaled.law[j];
  if (contact::damping(law) == 0) return 0;
  const double width = std::pow(scaled.length[j], contact::exponent(law) - 1);
  return contact::damping(law) * width * scaled.time[j] / scaled.reduced_mass[j];
}

}  // namespace mariotte::model
