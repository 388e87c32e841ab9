#include "family.hpp"

#include <algorithm>
#include <numeric>

#include "mariotte/impact/chain/chain_solver.hpp"

namespace mariotte::icr_table {
namespace {

contact::Law contact_law(const ContactLaw& law, double stiffness, double damping) {
  const double n = law.name == "linear" ? 1 : law.name == "hertz" ? 1.5 : law.exponent;
  if (damping > 0 || law.name == "viscoelastic")
    return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = n};
  if (law.name == "linear") return contact::Linear{stiffness};
  return contact::Hertz{stiffness};
}

}  // namespace

model::Chain chain(const Triplet& t, const ContactLaw& law) {
  return {.mass = {1, t.mass_2, t.mass_3},
          .law = {contact_law(law, 1, t.damping), contact_law(law, t.kappa, t.kappa * t.damping)},
          .gap = {0, 0},
          .velocity = {1, 0, t.v_3}};
}

model::Chain row(Index balls, double damping, const ContactLaw& law) {
  const auto n = static_cast<std::size_t>(balls);
  model::Chain chain{.mass = std::vector(n, 1.0),
                     .law = std::vector(n - 1, contact_law(law, 1, damping)),
                     .gap = std::vector(n - 1, 0.0),
                     .velocity = std::vector(n, 0.0)};
  chain.velocity[0] = 1;
  return chain;
}

impact::TablePoint simulate(const model::Chain& chain, double accuracy) {
  thread_local impact::ChainSolver solver;
  const auto& run = solver.solve(chain, {.accuracy = accuracy});
  if (run.ending != hybrid::Ending::separated) throw Error("an impact did not end: " + run.message);
  const auto before = impact::chain_configuration(chain.mass, chain.velocity);
  const double sum = std::accumulate(run.impulse.begin(), run.impulse.end(), 0.0);
  if (!(sum > 0)) return {};
  auto share = run.impulse;
  for (double& p : share) p = std::max(0.0, p / sum);
  return {.energy_ratio = relative_energy(before, run.velocity) / relative_energy(before, chain.velocity),
          .share = std::move(share)};
}

}  // namespace mariotte::icr_table
