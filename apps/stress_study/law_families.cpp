// Chains and networks of laws that yield, adhere, or have dampers of other kinds, in units of order one.
#include <cmath>
#include <memory>
#include <numbers>

#include "chain_parts.hpp"
#include "family.hpp"
#include "law_numbers.hpp"
#include "mariotte/contact/tabulated.hpp"
#include "natural.hpp"

namespace mariotte::stress_study {
namespace {

using contact::Law;
using contact::LawNumbers;
using std::numbers::pi;

Law make(const char* name, const LawNumbers& numbers) {
  return named_law(name).make(numbers);
}

/// How firmly bodies may adhere: work lost by a contact of Johnson, Kendall & Roberts over m* v²/2 at v = 1.
double some_adhesion(Dice& dice, const LawNumbers& numbers, double mass) {
  const double lost = dice.between(1e-4, 2) * mass / 2, r = numbers.effective_radius;
  return std::pow(std::pow(lost / 7.0922, 3) * std::pow(numbers.effective_modulus, 2) / std::pow(r, 4), 0.2);
}

/// A pressure that elastic balls reach at a depth.
double pressure_at(double depth, const LawNumbers& numbers) {
  return 2 * numbers.effective_modulus / pi * std::sqrt(depth / numbers.effective_radius);
}

LawNumbers some_sphere(Dice& dice, double mass) {
  LawNumbers numbers;
  numbers.effective_modulus = dice.decades(2);
  numbers.effective_radius = dice.decades(1);
  numbers.work_of_adhesion = some_adhesion(dice, numbers, mass);
  return numbers;
}

Law some_damper(Dice& dice, double mass) {
  LawNumbers numbers{.stiffness = dice.decades(2)};
  if (dice.chance(0.3)) {
    numbers.exponent = dice.pick({1, 1.5, dice.uniform(1, 3)});
    numbers.damping = dice.between(1e-3, 1) * std::sqrt(mass * numbers.stiffness);
    return make("viscoelastic", numbers);
  }
  if (dice.chance(0.5)) {
    numbers.damping = dice.between(1e-3, 3) * std::sqrt(mass * numbers.stiffness);
    return make("tsuji", numbers);
  }
  numbers.exponent = dice.pick({1, 1.5, dice.uniform(1, 3)});
  numbers.damping = dice.between(1e-3, 2);
  return make("hunt-crossley", numbers);
}

Law some_spring_and_damper(Dice& dice, double mass) {
  const Law law = some_damper(dice, mass);
  return dice.chance(0.3) ? contact::uncut(law) : law;
}

Law some_plastic(Dice& dice, double mass) {
  if (dice.chance(0.5)) {
    const double stiffness = dice.decades(2);
    return make("walton-braun",
                {.loading_stiffness = stiffness, .unloading_stiffness = stiffness * dice.between(1, 30)});
  }
  auto numbers = some_sphere(dice, mass);
  const Law elastic =
      contact::Hertz{4.0 / 3 * numbers.effective_modulus * std::sqrt(numbers.effective_radius)};
  numbers.yield_pressure = pressure_at(dice.between(1e-3, 2) * natural_depth(elastic, 1 / mass, 1), numbers);
  return make("thornton", numbers);
}

Law some_adhesive(Dice& dice, double mass) {
  auto numbers = some_sphere(dice, mass);
  const double e = numbers.effective_modulus, r = numbers.effective_radius;
  const int kind = dice.whole(0, 3);
  if (kind == 3) {
    numbers.damping_hertz = dice.pick({0, dice.between(1e-3, 1)});
    numbers.damping_adhesion = dice.pick({0, dice.between(1e-3, 1)});
    return make("brach-dunn", numbers);
  }
  if (kind == 0) {
    numbers.damping = dice.pick({0, dice.between(1e-3, 1) * e * std::sqrt(mass / (e * r))});
    return make("jkr", numbers);
  }
  if (kind == 1) {
    numbers.damping = dice.pick({0, dice.between(1e-3, 1) * std::sqrt(mass * e * r)});
    return make("dmt", numbers);
  }
  const Law elastic = contact::Hertz{4.0 / 3 * e * std::sqrt(r)};
  numbers.yield_pressure = least_yield_pressure(numbers) +
                           pressure_at(dice.between(1e-3, 2) * natural_depth(elastic, 1 / mass, 1), numbers);
  return make("thornton-ning", numbers);
}

/// A curve through points up to about the depth that bodies of this mass reach at v = 1.
Law some_curve(Dice& dice, double mass) {
  const int count = dice.whole(1, 20);
  const double depth = dice.decades(1), force = mass / depth * dice.between(0.1, 10);
  std::vector<contact::LawPoint> points;
  contact::LawPoint last{.indentation = 0, .force = 0};
  for (int i = 0; i < count; ++i) {
    last.indentation += depth * dice.uniform(0.05, 1) / count;
    last.force += force * dice.uniform(0.05, 1) / count;
    points.push_back(last);
  }
  return contact::SharedLaw(std::make_shared<contact::Tabulated>(std::move(points)));
}

using Draw = Law (*)(Dice&, double mass);

Law any_of_all(Dice& dice, double mass) {
  const Draw kinds[] = {some_spring_and_damper, some_plastic, some_adhesive, some_curve};
  return kinds[dice.whole(0, 3)](dice, mass);
}

void replace_laws(Dice& dice, model::Chain& chain, Draw draw) {
  const bool one_for_all = dice.chance(0.4);
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    chain.law[j] =
        one_for_all && j > 0 ? chain.law[0] : draw(dice, 1 / (1 / chain.mass[j] + 1 / chain.mass[j + 1]));
}

Scene limited(Dice& dice, model::Chain chain) {
  const double end = natural_time(chain) * dice.between(3, 30);
  return {.model = std::move(chain), .max_time = end};
}

/// Balls apart, since what adheres must not touch at rest.
model::Chain apart(Dice& dice, int balls, Draw draw) {
  auto chain = draw_row(dice, balls, Laws::hertz, dice.pick({0, 1, 2}), 0);
  replace_laws(dice, chain, draw);
  draw_velocities(dice, chain);
  for (double& gap : chain.gap) gap = dice.between(1e-3, 1);
  return chain;
}

Scene dampers(Dice& dice) {
  auto chain = apart(dice, dice.whole(2, 6), some_spring_and_damper);
  return {.model = std::move(chain)};
}

Scene plastic(Dice& dice) {
  auto chain = apart(dice, dice.whole(2, 6), some_plastic);
  return {.model = std::move(chain)};
}

/// Rows that touch, struck at an end.
Scene plastic_row(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(3, 8), Laws::hertz, dice.pick({0, 1}), 0);
  replace_laws(dice, chain, some_plastic);
  chain.velocity.front() = 1;
  if (dice.chance(0.3)) chain.velocity.back() = -dice.uniform(0, 1);
  return {.model = std::move(chain)};
}

/// Dents that are struck again and again.
Scene plastic_between_walls(Dice& dice) {
  auto chain = apart(dice, dice.whole(2, 4), some_plastic);
  add_wall(chain, true, dice.uniform(0.01, 1));
  add_wall(chain, false, dice.uniform(0.01, 1));
  return limited(dice, std::move(chain));
}

Scene adhesive(Dice& dice) {
  return limited(dice, apart(dice, dice.whole(2, 5), some_adhesive));
}

Scene adhesive_at_a_wall(Dice& dice) {
  auto chain = apart(dice, dice.whole(2, 4), some_adhesive);
  add_wall(chain, dice.chance(0.5), dice.uniform(0.01, 1));
  return limited(dice, std::move(chain));
}

Law curve_or_power(Dice& dice, double mass) {
  if (dice.chance(0.5)) return some_curve(dice, mass);
  return contact::PowerLaw{.stiffness = dice.decades(2), .exponent = dice.pick({1, 1.5, dice.uniform(1, 3)})};
}

/// Rows that touch or not, between walls or not.
Scene curves(Dice& dice) {
  auto chain = apart(dice, dice.whole(2, 8), dice.chance(0.5) ? some_curve : curve_or_power);
  if (dice.chance(0.5)) chain.gap.assign(chain.gap.size(), 0.0);
  if (dice.chance(0.3)) add_wall(chain, dice.chance(0.5), dice.uniform(0.01, 1));
  return {.model = std::move(chain)};
}

Scene mixture(Dice& dice) {
  return limited(dice, apart(dice, dice.whole(2, 6), any_of_all));
}

Scene network_of_laws(Dice& dice) {
  auto chain = apart(dice, dice.whole(3, 5), any_of_all);
  const double end = natural_time(chain) * dice.between(3, 30);
  return {.model = as_network(chain), .max_time = end};
}

}  // namespace

std::vector<Family> law_families() {
  return {{"other dampers", dampers},
          {"plastic chain", plastic},
          {"plastic row", plastic_row},
          {"plastic, walls", plastic_between_walls},
          {"adhesive chain", adhesive},
          {"adhesive, wall", adhesive_at_a_wall},
          {"mixed laws", mixture},
          {"network of laws", network_of_laws},
          {"curves", curves}};
}

}  // namespace mariotte::stress_study
