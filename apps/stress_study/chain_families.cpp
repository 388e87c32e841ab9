#include <algorithm>
#include <cmath>

#include "chain_parts.hpp"
#include "family.hpp"

namespace mariotte::stress_study {
namespace {

Scene plain(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 9), any_laws(dice));
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, dice.pick({0, 0.5, 1}), 2);
  return in_some_units(dice, chain);
}

Scene struck_row(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 9), any_laws(dice));
  chain.velocity.front() = 1;
  if (dice.chance(0.5)) chain.velocity.back() = -dice.pick({1, 0.5, dice.uniform(0, 1)});
  return in_some_units(dice, chain);
}

Scene long_row(Dice& dice) {
  auto chain =
      draw_row(dice, static_cast<int>(dice.between(10, 61)), dice.chance(0.5) ? Laws::hertz : any_laws(dice),
               dice.pick({0, 0, 0.3}), dice.pick({0, 0, 0.5}));
  chain.velocity.front() = 1;
  if (dice.chance(0.3)) chain.velocity.back() = -dice.uniform(0, 1);
  if (dice.chance(0.3)) draw_gaps(dice, chain, 0.3, 0.3);
  return in_some_units(dice, chain);
}

Scene equal_and_simultaneous(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 9), any_laws(dice), 0, 0);
  for (auto& law : chain.law) law = chain.law[0];
  for (double& v : chain.velocity) v = 0.5 * dice.whole(-2, 2);
  const double gap = dice.pick({0, 0, 1, 0.25});
  for (double& g : chain.gap) g = dice.chance(0.7) ? gap : 0;
  return in_some_units(dice, chain);
}

/// Mirrored masses, laws and speeds: everything happens twice at once.
Scene symmetric(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(3, 9), any_laws(dice));
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.5, 1);
  const auto n = chain.mass.size();
  for (std::size_t i = 0; i < n / 2; ++i) {
    chain.mass[n - 1 - i] = chain.mass[i];
    chain.velocity[n - 1 - i] = -chain.velocity[i];
  }
  if (n % 2) chain.velocity[n / 2] = 0;
  for (std::size_t j = 0; j < (n - 1) / 2; ++j) {
    chain.law[n - 2 - j] = chain.law[j];
    chain.gap[n - 2 - j] = chain.gap[j];
  }
  return in_some_units(dice, chain);
}

Scene many_decades(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 7), any_laws(dice), dice.uniform(0, 10), dice.uniform(0, 10));
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.3, 1);
  return in_some_units(dice, chain);
}

Scene strongly_damped(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 7), static_cast<Laws>(dice.whole(2, 4)));
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.3, 1);
  const double ratio = dice.between(1, 1e6);
  for (auto& law : chain.law)
    if (contact::dissipates(law))
      law =
          damped(contact::stiffness(law), ratio * dice.decades(dice.pick({0, 2})), contact::exponent(law), 1);
  return in_some_units(dice, chain);
}

Scene any_exponent(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 7), Laws::damped_any);
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.5, 1);
  return in_some_units(dice, chain);
}

Scene small_gaps(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 7), any_laws(dice));
  dice.chance(0.5) ? draw_velocities(dice, chain) : void(chain.velocity.front() = 1);
  for (double& gap : chain.gap) gap = dice.chance(0.8) ? dice.between(1e-12, 1) : 0;
  return in_some_units(dice, chain);
}

Scene grazing(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 6), any_laws(dice));
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.5, 1);
  for (std::size_t i = 1; i < chain.velocity.size(); ++i)
    if (dice.chance(0.6))
      chain.velocity[i] = chain.velocity[i - 1] + dice.pick({-1, 1}) * dice.between(1e-13, 1e-3);
  return in_some_units(dice, chain);
}

/// Light balls rattle between heavy ones.
Scene rattling(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(3, 9), any_laws(dice), 0.3, 1);
  draw_velocities(dice, chain);
  std::sort(chain.velocity.rbegin(), chain.velocity.rend());
  for (std::size_t i = 1; i < chain.mass.size(); i += 2) chain.mass[i] *= dice.between(1e-3, 0.3);
  draw_gaps(dice, chain, 0.7, 0.5);
  return in_some_units(dice, chain);
}

Scene moving_frame(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 6), any_laws(dice));
  draw_velocities(dice, chain);
  const double boost = dice.pick({-1, 1}) * dice.between(1, 1e4);
  for (double& v : chain.velocity) v += boost;
  return in_some_units(dice, chain);
}

Scene against_a_wall(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 7), any_laws(dice));
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, dice.pick({0, 0.5}), 1);
  const double velocity = dice.chance(0.3) ? dice.uniform(-0.5, 0.5) : 0;
  add_wall(chain, dice.chance(0.5), dice.pick({0, dice.uniform(0, 1)}), velocity);
  return in_some_units(dice, chain);
}

Scene between_walls(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 5), any_laws(dice), spread(dice) / 3, spread(dice) / 3);
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.7, 1);
  add_wall(chain, true, dice.uniform(0, 1));
  add_wall(chain, false, dice.uniform(0, 1));
  return in_some_units(dice, chain, natural_time(chain) * dice.uniform(1, 10));
}

Scene precompressed(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 7), any_laws(dice));
  if (dice.chance(0.5)) draw_velocities(dice, chain);
  chain.precompressed = true;
  const double depth = dice.between(1e-3, 1);
  for (double& gap : chain.gap)
    gap = dice.chance(0.7) ? -depth * dice.uniform(0.1, 1) : dice.pick({0, 1}) * dice.uniform(0, 1);
  return in_some_units(dice, chain);
}

Scene released_at_a_wall(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 6), any_laws(dice));
  chain.precompressed = true;
  add_wall(chain, dice.chance(0.5));
  if (dice.chance(0.3)) add_wall(chain, chain.mass.front() != infinity);
  for (double& gap : chain.gap) gap = -dice.between(1e-2, 1);
  return in_some_units(dice, chain, natural_time(chain) * dice.between(3, 30));
}

double some_gravity(Dice& dice) {
  return dice.pick({0.1, 1, dice.between(1e-3, 10)});
}

/// A wall at the end that gravity pulls towards.
void add_floor(Dice& dice, model::Chain& chain, double gap) {
  const bool left = dice.chance(0.7);
  add_wall(chain, left, gap);
  if (!left) chain.gravity = -chain.gravity;
}

Scene resting(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(1, 7), any_laws(dice), dice.pick({0, 0, 1}), dice.pick({0, 0, 2}));
  if (chain.law.empty()) chain.law.push_back(draw_law(dice, any_laws(dice), dice.decades(2), chain.mass[0]));
  const bool alone = chain.gap.empty();
  chain.gravity = some_gravity(dice);
  if (alone) {
    chain.mass.insert(chain.mass.begin(), infinity);
    chain.velocity.insert(chain.velocity.begin(), 0.0);
    chain.gap.push_back(0);
    if (dice.chance(0.2)) chain.velocity[1] = dice.uniform(0, 0.3);
  } else {
    add_floor(dice, chain, 0);
  }
  return in_some_units(dice, chain, natural_time(chain) * dice.between(1, 60));
}

Scene partly_resting(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 5), any_laws(dice), dice.pick({0, 1}), dice.pick({0, 1}));
  chain.gravity = some_gravity(dice);
  add_floor(dice, chain, 0);
  const bool left = chain.mass.front() == infinity;
  const auto last = chain.mass.size() - 1;
  chain.gap[left ? last - 1 : 0] = dice.uniform(0, 1);
  chain.velocity[left ? last : 0] = (left ? -1 : 1) * dice.uniform(-0.3, 1);
  return in_some_units(dice, chain, natural_time(chain) * dice.between(1, 30));
}

Scene dropped(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 6), any_laws(dice), dice.pick({0, 1}), dice.pick({0, 1}));
  if (dice.chance(0.5)) draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.5, 0.3);
  chain.gravity = some_gravity(dice);
  const double height = dice.pick({0, dice.between(1e-6, 1)});
  add_floor(dice, chain, height);
  const double fall = std::sqrt(2 * height / std::abs(chain.gravity));
  return in_some_units(dice, chain, fall + natural_time(chain) * dice.between(1, 20));
}

/// Gravity without a wall changes nothing but the frame; upwards from a wall it leads away.
Scene falling_freely(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 6), any_laws(dice));
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.3, 1);
  chain.gravity = dice.pick({-1, 1}) * some_gravity(dice);
  if (dice.chance(0.3)) {
    add_wall(chain, chain.gravity < 0);
    return in_some_units(dice, chain, natural_time(chain) * dice.between(1, 30));
  }
  return in_some_units(dice, chain);
}

}  // namespace

std::vector<Family> chain_families() {
  return {{"plain chain", plain},
          {"struck row", struck_row},
          {"long row", long_row, 20},
          {"equal balls", equal_and_simultaneous},
          {"mirrored chain", symmetric},
          {"many decades", many_decades},
          {"strong damping", strongly_damped},
          {"any exponent", any_exponent},
          {"small gaps", small_gaps},
          {"grazing", grazing},
          {"rattling", rattling},
          {"moving frame", moving_frame},
          {"wall", against_a_wall},
          {"between walls", between_walls},
          {"precompressed", precompressed},
          {"released at a wall", released_at_a_wall},
          {"resting row", resting},
          {"partly resting", partly_resting},
          {"dropped row", dropped},
          {"free fall", falling_freely}};
}

}  // namespace mariotte::stress_study
