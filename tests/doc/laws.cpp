// Prints how far impact laws are from the compliant chain, as doc/impact_laws.md quotes it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/laws/liu_zhao_brogliato_law.hpp"
#include "mariotte/impact/laws/multiple_impact_law.hpp"
#include "mariotte/impact/laws/rival_laws.hpp"

using namespace mariotte;
using impact::LawOutcome;
using Numbers = std::vector<double>;

namespace {

/// n balls that touch, struck by the first.
model::Chain struck_row(std::size_t balls, double damping) {
  model::Chain chain{.mass = Numbers(balls, 1.0),
                     .law = {},
                     .gap = Numbers(balls - 1, 0.0),
                     .velocity = Numbers(balls, 0.0)};
  chain.velocity[0] = 1;
  chain.law.assign(balls - 1, contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = 1.5});
  return chain;
}

Numbers simulated(const model::Chain& chain) {
  return impact::ChainSolver().solve(chain, {.accuracy = 1e-11}).velocity;
}

void print_row(const char* name, const impact::Configuration& before, const LawOutcome& outcome,
               const Numbers& truth) {
  double worst = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    worst = std::max(worst, std::abs(outcome.velocity[i] - truth[i]));
  const double energy = kinetic_energy(before, outcome.velocity) - kinetic_energy(before, truth);
  const double dispersion = energy_dispersion(before, outcome.velocity) - energy_dispersion(before, truth);
  const auto clean = [](double x) { return std::abs(x) < 5e-7 ? 0.0 : x; };
  std::printf("%8zu  %-19s %-21s %9.4f %9.4f %11.4f\n", truth.size(), name, impact::name(outcome.status),
              clean(worst), clean(energy / kinetic_energy(before, before.velocity)), clean(dispersion));
}

void compare(std::size_t balls, double damping, double restitution) {
  const auto chain = struck_row(balls, damping);
  const auto truth = simulated(chain);
  const auto before = impact::chain_configuration(chain.mass, chain.velocity);
  Numbers p = {before.velocity[0] - truth[0]};
  for (std::size_t i = 1; i + 1 < balls; ++i) p.push_back(p.back() - truth[i]);
  print_row("multiple-impact", before, multiple_impact(before, parameters_of(before, p, truth)), truth);
  for (const auto& [name, outcome] : rival_outcomes(before, {.restitution = restitution, .direction = p}))
    print_row(name.c_str(), before, outcome, truth);
}

/// Five undamped Hertz balls in a row, the second and fourth of another mass, and the distribution law, which
/// knows stiffnesses and loses nothing.
void compare_unequal(double ratio) {
  auto chain = struck_row(5, 0);
  chain.mass[1] = chain.mass[3] = ratio;
  const auto truth = impact::simulate(chain, {.accuracy = 1e-11});
  const auto law = liu_zhao_brogliato(
      impact::chain_configuration(chain.mass, chain.velocity),
      {.restitution = Numbers(4, 1.0), .stiffness = Numbers(4, 1.0), .exponent = Numbers(4, 1.5)});
  double worst = 0;
  for (std::size_t i = 0; i < 5; ++i) worst = std::max(worst, std::abs(law.velocity[i] - truth.velocity[i]));
  std::size_t most = 0;
  for (const auto& contact : truth.contacts) most = std::max(most, contact.periods.size());
  std::printf("%10.2f  %20zu %9.4f\n", ratio, most, worst < 5e-7 ? 0.0 : worst);
}

}  // namespace

int main() {
  for (const double damping : {0.0, 0.3}) {
    const auto pair = simulated(struck_row(2, damping));
    const double restitution = damping > 0 ? pair[1] - pair[0] : 1;
    std::printf("damping %.1f, restitution of two balls %.6f\n", damping, restitution);
    std::printf("%8s  %-19s %-21s %9s %9s %11s\n", "balls", "law", "outcome", "velocity", "energy",
                "dispersion");
    for (const std::size_t balls : {3, 5, 10}) compare(balls, damping, restitution);
  }
  std::printf("liu-zhao-brogliato without damping, masses 1, m, 1, m, 1\n");
  std::printf("%10s  %20s %9s\n", "m", "periods of a contact", "velocity");
  for (const double ratio : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) compare_unequal(ratio);
}
