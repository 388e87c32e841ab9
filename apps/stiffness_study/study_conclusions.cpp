// The conclusions of [Acary 2003, §4] for finite-dimensional systems, on chains at random: masses over two
// decades, stiffnesses over four, gaps on half of the contacts, velocities in any direction.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/laws/multiple_impact_law.hpp"
#include "study.hpp"

namespace mariotte::stiffness_study {
namespace {

using Numbers = std::vector<double>;
using Random = std::mt19937_64;

constexpr double tight = 1e-12;  ///< accuracy of runs that are compared with each other

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution(low, high)(random);
}

contact::Law random_law(Random& random, bool linear) {
  const double stiffness = std::pow(10, uniform(random, -2, 2));
  if (linear) return contact::Linear{stiffness};
  const double damping = uniform(random, 0, 1) * std::sqrt(stiffness);
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = uniform(random, 1, 2)};
}

model::Chain random_chain(Random& random, bool linear) {
  const int balls = std::uniform_int_distribution(3, 8)(random);
  model::Chain chain;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(std::pow(10, uniform(random, -1, 1)));
    chain.velocity.push_back(uniform(random, -1, 1));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.law.push_back(random_law(random, linear));
    chain.gap.push_back(linear || uniform(random, 0, 1) < 0.5 ? 0 : uniform(random, 0, 1));
  }
  return chain;
}

double largest_difference(const Numbers& a, const Numbers& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

/// Conclusion 1: r and e make the velocities after the impact, and only one of the two roots will do.
Statement law_closes_the_equations(Index count) {
  Random random(1);
  impact::ChainSolver solver;
  double worst = 0;
  Index impacts = 0, second = 0;
  for (Index i = 0; i < count; ++i) {
    const auto chain = random_chain(random, false);
    const auto& run = solver.solve(chain, {.accuracy = tight});
    const auto before = impact::chain_configuration(chain.mass, chain.velocity);
    const auto parameters =
        parameters_of(before, run.impulse, run.velocity, impact::EnergyFrame::mass_centre);
    const auto outcome = multiple_impact(before, parameters);
    if (!outcome.least_energy_ratio) continue;
    ++impacts;
    worst = std::max(worst, largest_difference(outcome.velocity, run.velocity));
    // The roots lie symmetric about the plastic impact, p·w = 0; below it the contacts still close.
    const auto plastic = multiple_impact(before, {.direction = parameters.direction,
                                                  .energy_ratio = *outcome.least_energy_ratio,
                                                  .frame = parameters.frame});
    auto smaller = outcome.impulse;
    for (std::size_t j = 0; j < smaller.size(); ++j) smaller[j] = 2 * plastic.impulse[j] - smaller[j];
    second += outcome_of(before, smaller).status == impact::LawStatus::admissible;
  }
  return {
      Statement::Kind::theorem,
      fmt::format("1: the law gives the velocities of {} simulated impacts within {:.1e}; the other root is "
                  "admissible in {}",
                  impacts, worst, second),
      impacts > count / 2 && worst < 1e-10 && second == 0};
}

/// Conclusion 2(a): the state comes to {gaps open or opening, no force} and stays there; ratios are finite.
Statement impacts_end(Index count) {
  Random random(2);
  Index ended = 0, pressed = 0, finite = 0;
  double force = 0, approach = 0;
  for (Index i = 0; i < count; ++i) {
    const auto chain = random_chain(random, false);
    const auto run = impact::simulate(chain);
    ended += run.ending == hybrid::Ending::separated;
    for (std::size_t j = 0; j < run.contacts.size(); ++j) {
      const auto& contact = run.contacts[j];
      if (contact.periods.empty()) continue;
      ++pressed;
      finite +=
          contact.impulse > 0 && std::isfinite(contact.impulse) && contact.periods.back().end.has_value();
      const double rate = run.velocity[j + 1] - run.velocity[j];
      approach = std::max(approach, -rate);
      const auto& law = chain.law[j];
      const double load = -contact::stiffness(law) * run.gap[j] - contact::damping(law) * rate;
      if (run.gap[j] < 0) force = std::max(force, load);
    }
  }
  return {
      Statement::Kind::theorem,
      fmt::format("2(a): {} of {} damped impacts end, each of {} contacts that pushed with a positive finite "
                  "impulse ({} of them); at the end gaps close with at most {:.1e} and the largest load left "
                  "is {:.1e}",
                  ended, count, pressed, finite, approach, force),
      ended == count && finite == pressed && approach < 1e-9 && force < 1e-9};
}

/// The chain with all stiffnesses and masses multiplied.
model::Chain scaled(model::Chain chain, double stiffer, double heavier) {
  for (double& mass : chain.mass) mass *= heavier;
  for (auto& law : chain.law) law = contact::Linear{stiffer * contact::stiffness(law)};
  return chain;
}

/// Conclusion 3 and Prop. 2.1: K → sK and M → tM keep the natural modes; the modes alone give the impulses.
/// A light ball that rattles between heavy ones doubles any rounding at each turn, so only powers of two,
/// which round nothing, can be asked of all chains; the others of those with few events.
Statement modes_decide(Index count) {
  constexpr Index few = 40;
  Random random(3);
  impact::ChainSolver solver;
  const auto solve = [&](const model::Chain& chain, const char* flow) {
    return impact::direction(
        solver.solve(chain, {.accuracy = tight, .flow = flow::parse_kind(flow)}).impulse);
  };
  double by_powers = 0, by_any = 0, apart = 0;
  Index calm = 0;
  for (Index i = 0; i < count; ++i) {
    const auto chain = random_chain(random, true);
    const auto modal = solve(chain, "modal");
    const bool compared = solver.solve(chain, {.accuracy = tight}).events <= few;
    by_powers =
        std::max(by_powers, largest_difference(modal, solve(scaled(chain, 0x1p40, 0x1p-20), "modal")));
    const double stiffer = std::pow(10, uniform(random, -9, 9)),
                 heavier = std::pow(10, uniform(random, -9, 9));
    if (!compared) continue;
    ++calm;
    by_any = std::max(by_any, largest_difference(modal, solve(scaled(chain, stiffer, heavier), "modal")));
    apart = std::max(apart, largest_difference(modal, solve(chain, "taylor")));
  }
  return {
      Statement::Kind::theorem,
      fmt::format("3: impulse directions of {} linear chains move by {:.1e} when stiffnesses and masses are "
                  "scaled by 2^40 and 2^-20; those of the {} with at most {} events by {:.1e} when by up to "
                  "10^±9, and natural modes and series differ there by {:.1e}",
                  count, by_powers, calm, few, by_any, apart),
      by_powers == 0 && calm > count / 2 && by_any < 1e-9 && apart < 1e-9};
}

}  // namespace

Findings conclusions_study(const Settings& settings) {
  const Index count = settings.quick ? 100 : 2000;
  return {.rows = {},
          .statements = {law_closes_the_equations(count), impacts_end(count), modes_decide(count)},
          .figures = {}};
}

}  // namespace mariotte::stiffness_study
