#include "mariotte/impact/multiple_impact_law.hpp"

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

Numbers sum(Numbers a, const Numbers& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

double largest(const Numbers& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
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
struct EnergyBalance {
  double a, b, s;

  double least_ratio() const { return 1 - b / a * (b / s); }
  /// The larger root for this e; empty if complex by more than rounding.
  std::optional<double> size(double e) const {
    const double discriminant = b * b - a * (1 - e) * s;
    if (discriminant < -8 * epsilon * b * b) return std::nullopt;
    return (b + std::sqrt(std::max(0.0, discriminant))) / a;
  }
};

void validate(const Configuration& c, const LawParameters& parameters) {
  validate(c);
  const auto finite = [](double value) { return std::isfinite(value); };
  if (parameters.direction.size() != c.contact.size())
    throw InvalidParameter("the impulse direction needs one value per contact");
  if (!std::all_of(parameters.direction.begin(), parameters.direction.end(), finite))
    throw InvalidParameter("the impulse direction must be finite");
  if (!(parameters.energy_ratio >= 0) || !finite(parameters.energy_ratio))
    throw InvalidParameter("the energy ratio must be finite and not negative");
}

std::optional<Index> first_below(const Numbers& values, double bound) {
  const auto found = std::find_if(values.begin(), values.end(), [&](double v) { return v < bound; });
  return found == values.end() ? std::nullopt : std::optional(found - values.begin());
}

/// Whether a contact pulls or goes on closing.
void judge(LawOutcome& outcome, const Configuration& c, double slow) {
  const auto rates = gap_rates(c, outcome.velocity);
  const double speed = std::max(largest(rates), largest(gap_rates(c, c.velocity)));
  outcome.status = LawStatus::admissible;
  if ((outcome.contact = first_below(outcome.impulse, 0)))
    outcome.status = LawStatus::tensile_impulse;
  else if ((outcome.contact = first_below(rates, -slow * speed)))
    outcome.status = LawStatus::penetrating_velocity;
}

std::optional<double> ratio(double after, double before) {
  return before > 0 ? std::optional(after / before) : std::nullopt;
}

void add_ratios(LawOutcome& outcome, const Configuration& c) {
  outcome.ratio_lab = ratio(kinetic_energy(c, outcome.velocity), kinetic_energy(c, c.velocity));
  outcome.ratio_centre = ratio(relative_energy(c, outcome.velocity), relative_energy(c, c.velocity));
}

}  // namespace

LawOutcome multiple_impact(const Configuration& c, const LawParameters& parameters) {
  validate(c, parameters);
  const auto r = direction(parameters.direction);
  const auto unit_change = velocity_change(c, r);
  const EnergyBalance balance{.a = dot(generalised_impulse(c, r), unit_change),
                              .b = -dot(r, gap_rates(c, c.velocity)),
                              .s = energy_before(c, parameters.frame)};
  LawOutcome outcome{
      .status = LawStatus::no_impact, .impulse = Numbers(r.size(), 0.0), .velocity = c.velocity};
  if (balance.b > 0 && balance.a > 0) {
    outcome.least_energy_ratio = balance.least_ratio();
    const auto size = balance.size(parameters.energy_ratio);
    if (!size) return {.status = LawStatus::complex, .least_energy_ratio = outcome.least_energy_ratio};
    for (std::size_t j = 0; j < r.size(); ++j) outcome.impulse[j] = *size * r[j];
    outcome.velocity = sum(c.velocity, velocity_change(c, outcome.impulse));
    judge(outcome, c, parameters.slow);
  }
  add_ratios(outcome, c);
  return outcome;
}

const char* name(LawStatus status) {
  switch (status) {
    case LawStatus::admissible:
      return "admissible";
    case LawStatus::tensile_impulse:
      return "tensile_impulse";
    case LawStatus::penetrating_velocity:
      return "penetrating_velocity";
    case LawStatus::complex:
      return "complex";
    case LawStatus::no_impact:
      return "no_impact";
  }
  return "complex";
}

std::string reason(const LawOutcome& outcome) {
  const auto at = outcome.contact ? "contact " + std::to_string(*outcome.contact + 1) : "";
  switch (outcome.status) {
    case LawStatus::admissible:
      return "";
    case LawStatus::tensile_impulse:
      return at + " would pull: its impulse is negative";
    case LawStatus::penetrating_velocity:
      return at + " would go on closing after the impact";
    case LawStatus::complex:
      return "no real impulse loses so much energy: the energy ratio must be at least " +
             std::to_string(*outcome.least_energy_ratio);
    case LawStatus::no_impact:
      return "no impact: along the impulse direction nothing approaches";
  }
  return "";
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
  const auto energy = frame == EnergyFrame::given ? kinetic_energy : relative_energy;
  const double kinetic = energy(before, before.velocity);
  if (!(kinetic > 0))
    throw InvalidParameter("without energy before the impact the energy ratio has no meaning");
  return {.direction = direction(impulse),
          .energy_ratio = energy(before, velocity_after) / kinetic,
          .frame = frame};
}

LawParameters parameters_of(const ChainImpact& impact, EnergyFrame frame) {
  const auto& energy = impact.energy;
  const auto ratio = frame == EnergyFrame::given ? energy.ratio_lab : energy.ratio_centre;
  if (!ratio) throw InvalidParameter("the energy ratio of this impact is not defined in that frame");
  return {.direction = impact.impulse_direction,
          .energy_ratio = *ratio,
          .frame = frame,
          .slow = std::max(1e-12, impact.requested_accuracy)};
}

}  // namespace mariotte::impact
