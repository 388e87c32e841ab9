#include "mariotte/impact/laws/rival_laws.hpp"

#include <cmath>

#include "mariotte/impact/laws/ceanga_hurmuzlu_law.hpp"
#include "mariotte/impact/laws/liu_zhao_brogliato_law.hpp"
#include "mariotte/impact/laws/moreau_law.hpp"
#include "mariotte/impact/laws/newton_law.hpp"
#include "mariotte/impact/laws/poisson_law.hpp"
#include "mariotte/impact/laws/sequential_law.hpp"

namespace mariotte::impact {
namespace {

LawOutcome distributed(const Configuration& c, const std::vector<double>& e,
                       const RivalParameters& parameters) {
  DistributionLaw law{.restitution = e, .stiffness = parameters.stiffness, .exponent = parameters.exponent};
  if (law.stiffness.empty()) law.stiffness.assign(e.size(), 1.0);
  if (law.exponent.empty()) law.exponent.assign(e.size(), 1.5);
  return liu_zhao_brogliato(c, law);
}

}  // namespace

std::vector<NamedOutcome> rival_outcomes(const Configuration& c, const RivalParameters& parameters) {
  const std::vector<double> e(c.contact.size(), parameters.restitution);
  std::vector<NamedOutcome> outcomes = {{"newton", newton(c, e)},
                                        {"poisson", poisson(c, e)},
                                        {"moreau", moreau(c, parameters.restitution)},
                                        {"left-to-right", left_to_right(c, {.restitution = e})},
                                        {"by-event", by_event(c, {.restitution = e})}};
  if (parameters.restitution > 0 && parameters.distributes)
    outcomes.push_back({"liu-zhao-brogliato", distributed(c, e, parameters)});
  if (!parameters.direction.empty())
    outcomes.push_back(
        {"ceanga-hurmuzlu", ceanga_hurmuzlu(c, {.restitution = e, .direction = parameters.direction})});
  return outcomes;
}

double energy_dispersion(const Configuration& c, const std::vector<double>& velocity) {
  const double total = kinetic_energy(c, velocity);
  if (!(total > 0)) return 0;
  double even = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const double share = std::isinf(c.mass[i]) ? 0 : 0.5 * c.mass[i] * velocity[i] * velocity[i] / total;
    even += share * share;
  }
  return 1 - even;
}

}  // namespace mariotte::impact
