#include "mariotte/impact/chain/chain_gate.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/impact/unloaded_depth.hpp"

namespace mariotte::impact {

namespace {

/// Momenta and energies that velocity errors of 1 × reference speed could be of, and what gravity gives.
struct Reach {
  double momentum = 0, energy = 0;
};

Reach reach(const ChainOutcome& o) {
  Reach sum;
  for (Index i = 0; i < o.layout.velocities(); ++i) {
    if (o.chain.inverse_mass[i] == 0) continue;
    const Index at = o.layout.velocity[i];
    const double fastest =
        o.chain.speed + std::max(std::abs(o.interval.before[at]), std::abs(o.interval.after[at]));
    sum.momentum += o.chain.mass[i] * (fastest + std::abs(o.chain.gravity[i]) * o.interval.time);
    sum.energy += o.chain.mass[i] * fastest * fastest;
  }
  return sum;
}

double largest_wall_speed(const ChainOutcome& o) {
  double speed = 0;
  for (Index i = 0; i < o.layout.velocities(); ++i)
    if (o.chain.inverse_mass[i] == 0)
      speed = std::max(speed, std::abs(o.interval.before[o.layout.velocity[i]]));
  return speed;
}

/// Largest impulse of a contact that pulled, or never closed.
double wrong_impulse(const ChainOutcome& o) {
  double worst = 0;
  for (std::size_t j = 0; j < o.impulses.size(); ++j)
    if (o.periods[j] == 0 || !contact::pulls(o.chain.law[j]))
      worst = std::max(worst, o.periods[j] > 0 ? -o.impulses[j] : std::abs(o.impulses[j]));
  return worst;
}

/// What rounding makes of impulses that have been summed over very many steps, of walls that are pressed for
/// long: ε of the sum at each, at random.
double rounding(const ChainOutcome& o) {
  constexpr double root_of_steps = 1000;
  double sum = 0;
  for (const double impulse : o.impulses) sum += std::abs(impulse);
  return root_of_steps * epsilon * sum;
}

/// Fastest approach of two neighbours whose contact is `among` those asked for.
template <class Among>
double approach(const ChainOutcome& o, Among&& among) {
  double worst = 0;
  for (Index j = 0; j < o.layout.contacts(); ++j) {
    const auto& v = o.layout.velocity;
    if (among(o.mode[j])) worst = std::max(worst, o.interval.after[v[j]] - o.interval.after[v[j + 1]]);
  }
  return worst;
}

double energy_gain(const ChainOutcome& o) {
  double worst = 0;
  for (const auto& energy : o.energies) worst = std::max(worst, gain(energy));
  return worst;
}

}  // namespace

void pass_gate(const ChainOutcome& o, double accuracy, hybrid::Ending& ending, std::string& message) {
  const double share = balance_allowance * std::max(accuracy, 16 * epsilon);
  const auto [momentum, energy] = reach(o);
  const double allowed = share * (energy + largest_wall_speed(o) * momentum);
  const auto balance = energy_balance(o.chain, o.layout, o.energies, o.impulses, o.interval);
  const auto momenta = momentum_balance(o.chain, o.layout, o.interval);
  const double explained = allowed + share * std::abs(balance.work);
  const bool parts = ending == hybrid::Ending::separated && !o.chain.falls_back;
  const Balance balances[] = {
      {"an approach at the end", approach(o, [&](auto mode) { return parts || is_slack(mode); }),
       balance_allowance * o.chain.noise_speed},
      {"the energy balance, in units of the run,", balance.residual, explained},
      {"the momentum balance, in units of the run,", momenta.residual, share * momentum + rounding(o)},
      {"an impulse that pulls, or of a contact that never closed", wrong_impulse(o), share * momentum},
      {"the energy that a contact has gained", energy_gain(o), explained},
      {"an indentation without force, relative to what cannot be told from rest,",
       unloaded_depth(o.chain, o.layout, o.mode, o.interval.after, accuracy), 1},
  };
  pass_gate(balances, ending, message);
}

}  // namespace mariotte::impact
