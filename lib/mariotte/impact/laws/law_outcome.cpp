#include "mariotte/impact/laws/law_outcome.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/laws/restitution.hpp"

namespace mariotte::impact {
namespace {

using Numbers = std::vector<double>;

double largest(const Numbers& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
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

void add_ratios(LawOutcome& outcome, const Configuration& c) {
  outcome.ratio_lab = energy_ratio(kinetic_energy(c, outcome.velocity), kinetic_energy(c, c.velocity));
  const auto relative = relative_energies(c, {outcome.velocity, c.velocity});
  outcome.ratio_centre = energy_ratio(relative[0], relative[1]);
}

std::string digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.15g", value);
  return text.data();
}

}  // namespace

LawOutcome outcome_of(const Configuration& c, Numbers impulse, double slow) {
  LawOutcome outcome{.impulse = std::move(impulse), .velocity = c.velocity};
  const auto change = velocity_change(c, outcome.impulse);
  for (std::size_t i = 0; i < change.size(); ++i) outcome.velocity[i] += change[i];
  judge(outcome, c, slow);
  add_ratios(outcome, c);
  return outcome;
}

void validate(const Configuration& c, const Numbers& restitution) {
  validate(c);
  if (restitution.size() != c.contact.size())
    throw InvalidParameter("an impact law needs one coefficient of restitution per contact");
  for (const double e : restitution)
    if (!(e >= 0 && e <= 1)) throw InvalidParameter("a coefficient of restitution must lie between 0 and 1");
}

void validate_direction(const Configuration& c, const Numbers& direction) {
  if (direction.size() != c.contact.size())
    throw InvalidParameter("the impulse direction needs one value per contact (" +
                           std::to_string(c.contact.size()) + "), got " + std::to_string(direction.size()) +
                           "; of ratios there is one less");
  for (const double r : direction)
    if (!std::isfinite(r)) throw InvalidParameter("the impulse direction must be finite");
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
    case LawStatus::unfinished:
      return "unfinished";
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
             digits(*outcome.least_energy_ratio);
    case LawStatus::no_impact:
      return "no impact: along the impulse direction nothing approaches";
    case LawStatus::unfinished:
      return "the law came to no end within its limit of collisions or steps";
  }
  return "";
}

}  // namespace mariotte::impact
