// Long rows of equal balls, or nearly so, whose waves become steady.
#include <cmath>

#include "chain_parts.hpp"
#include "family.hpp"

namespace mariotte::stress_study {
namespace {

/// A light striker sends one wave. Behind heavier ones balls rattle, and errors grow.
model::Chain equal_row(Dice& dice, int most = 400) {
  const int balls = dice.whole(130, most);
  const double exponent = dice.chance(0.4) ? 1.5 : dice.uniform(1.15, 3.5);
  model::Chain chain{.mass = std::vector<double>(balls, 1.0),
                     .law = std::vector<contact::Law>(balls - 1, contact::PowerLaw{1, 0, exponent}),
                     .gap = std::vector<double>(balls - 1, 0.0),
                     .velocity = std::vector<double>(balls, 0.0)};
  const bool backward = dice.chance(0.5);
  chain.mass[backward ? balls - 1 : 0] = dice.between(0.2, 1);
  chain.velocity[backward ? balls - 1 : 0] = backward ? -1 : 1;
  return chain;
}

/// One of the balls in the middle third.
std::size_t somewhere(Dice& dice, const model::Chain& chain) {
  const int balls = static_cast<int>(chain.mass.size());
  return static_cast<std::size_t>(dice.whole(balls / 3, 2 * balls / 3));
}

/// Long enough for the wave to pass the row once, at most.
Scene once(Dice& dice, const model::Chain& chain) {
  const auto balls = static_cast<double>(chain.mass.size());
  return in_some_units(dice, chain, balls * dice.uniform(0.5, 1.2));
}

Scene equal(Dice& dice) {
  return in_some_units(dice, equal_row(dice));
}

Scene with_a_heavy_or_light_ball(Dice& dice) {
  auto chain = equal_row(dice);
  chain.mass[somewhere(dice, chain)] = dice.uniform(0.5, 2);
  return once(dice, chain);
}

Scene with_a_stiff_or_soft_contact(Dice& dice) {
  auto chain = equal_row(dice);
  const double exponent = contact::exponent(chain.law[0]);
  chain.law[somewhere(dice, chain)] = contact::PowerLaw{dice.uniform(0.5, 2), 0, exponent};
  return once(dice, chain);
}

Scene with_a_gap(Dice& dice) {
  auto chain = equal_row(dice);
  chain.gap[somewhere(dice, chain)] = dice.between(1e-3, 100);
  return once(dice, chain);
}

/// Every second or third ball is another one: most such rows let no wave be steady, and all of
/// their balls rattle.
Scene periodic(Dice& dice) {
  auto chain = equal_row(dice, 180);
  const auto period = static_cast<std::size_t>(dice.whole(2, 3));
  const double mass = dice.uniform(0.6, 1.6);
  for (std::size_t i = period; i + 1 < chain.mass.size(); i += period) chain.mass[i] = mass;
  return once(dice, chain);
}

Scene struck_from_both_ends(Dice& dice) {
  auto chain = equal_row(dice);
  auto& other = chain.velocity.front() == 0 ? chain.velocity.front() : chain.velocity.back();
  other = (chain.velocity.front() == 0 ? 1 : -1) * dice.uniform(0, 1);
  return once(dice, chain);
}

Scene before_a_wall(Dice& dice) {
  auto chain = equal_row(dice);
  add_wall(chain, chain.velocity.front() == 0);
  return once(dice, chain);
}

}  // namespace

std::vector<Family> row_families() {
  return {{"equal row", equal},
          {"row with another ball", with_a_heavy_or_light_ball},
          {"row with another contact", with_a_stiff_or_soft_contact},
          {"row with a gap", with_a_gap},
          {"periodic row", periodic},
          {"row struck at both ends", struck_from_both_ends},
          {"row before a wall", before_a_wall}};
}

}  // namespace mariotte::stress_study
