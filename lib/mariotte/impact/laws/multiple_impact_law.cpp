#include "mariotte/impact/laws/multiple_impact_law.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/impulses.hpp"

namespace mariotte::impact {
namespace {

using Numbers = std::vector<double>;

double dot(const Numbers& a, const Numbers& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Energies before in the frame of e, twice the kinetic one.
double energy_before(const Configuration& c, EnergyFrame frame) {
  if (frame == EnergyFrame::mass_centre) return 2 * relative_energy(c, c.velocity);
  for (std::size_t i = 0; i < c.velocity.size(); ++i)
    if (std::isinf(c.mass[i]) && c.velocity[i] != 0)
      throw InvalidParameter("a wall moves: compare energies relative to the mass centre");
  return 2 * kinetic_energy(c, c.velocity);
}

/// A P² − 2 B P + (1 − e) S = 0.
struct SizeEquation {
  double a, b, s;

  double least_ratio() const { return 1 - b / a * (b / s); }
  /// The larger root for this e; empty if complex by more than the rounding of e and of the terms.
  std::optional<double> size(double e) const {
    const double discriminant = b * b - a * (1 - e) * s;
    if (discriminant < -8 * epsilon * (b * b + a * s)) return std::nullopt;
    return (b + std::sqrt(std::max(0.0, discriminant))) / a;
  }
};

void validate(const Configuration& c, const LawParameters& parameters) {
  validate(c);
  validate_direction(c, parameters.direction);
  if (!(parameters.energy_ratio >= 0) || !std::isfinite(parameters.energy_ratio))
    throw InvalidParameter("the energy ratio must be finite and not negative");
}

}  // namespace

LawOutcome multiple_impact(const Configuration& c, const LawParameters& parameters) {
  validate(c, parameters);
  const auto r = direction(parameters.direction);
  const SizeEquation equation{.a = dot(generalised_impulse(c, r), velocity_change(c, r)),
                              .b = -dot(r, gap_rates(c, c.velocity)),
                              .s = energy_before(c, parameters.frame)};
  if (!(equation.b > 0 && equation.a > 0)) {
    auto outcome = outcome_of(c, Numbers(r.size(), 0.0));
    outcome.status = LawStatus::no_impact;
    return outcome;
  }
  const auto size = equation.size(parameters.energy_ratio);
  if (!size) return {.status = LawStatus::complex, .least_energy_ratio = equation.least_ratio()};
  auto p = r;
  for (double& impulse : p) impulse *= *size;
  auto outcome = outcome_of(c, std::move(p), parameters.slow);
  outcome.least_energy_ratio = equation.least_ratio();
  return outcome;
}

Numbers direction_of_ratios(const Numbers& icr) {
  Numbers r(icr.size() + 1, 1.0);
  for (std::size_t j = icr.size(); j-- > 0;) {
    r[j] = icr[j] * r[j + 1];
    if (!std::isfinite(r[j]))
      throw InvalidParameter("impulse correlation ratio " + std::to_string(j + 1) +
                             " makes no finite direction: give the impulse direction");
  }
  return r;
}

LawParameters parameters_of(const Configuration& before, const Numbers& impulse,
                            const Numbers& velocity_after, EnergyFrame frame) {
  const auto energy =
      frame == EnergyFrame::mass_centre
          ? relative_energies(before, {before.velocity, velocity_after})
          : Numbers{kinetic_energy(before, before.velocity), kinetic_energy(before, velocity_after)};
  if (!(energy[0] > 0))
    throw InvalidParameter("without energy before the impact the energy ratio has no meaning");
  return {.direction = direction(impulse), .energy_ratio = energy[1] / energy[0], .frame = frame};
}

LawParameters parameters_of(const ContactImpact& impact, EnergyFrame frame) {
  const auto& energy = impact.energy;
  const auto ratio = frame == EnergyFrame::given ? energy.ratio_lab : energy.ratio_centre;
  if (!ratio) throw InvalidParameter("the energy ratio of this impact is not defined in that frame");
  return {.direction = impact.impulse_direction,
          .energy_ratio = *ratio,
          .frame = frame,
          .slow = std::max(rounding, impact.requested_accuracy)};
}

}  // namespace mariotte::impact
