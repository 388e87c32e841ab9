#include "chain_parts.hpp"

#include <algorithm>
#include <cmath>

#include "natural.hpp"

namespace mariotte::stress_study {
namespace {

double reduced(double a, double b) {
  return 1 / (1 / a + 1 / b);
}

/// N/m^n and N s/m^n in other units.
struct Units {
  double mass, length, time;

  double stiffness(double value, double n) const {
    return value * mass / time / time * std::pow(length, 1 - n);
  }
  void change(contact::PowerLaw& law) const {
    law.stiffness = stiffness(law.stiffness, law.exponent);
    law.damping = time * stiffness(law.damping, law.exponent);
  }
};

void change(const Units& units, model::Chain& chain) {
  for (double& m : chain.mass) m *= units.mass;
  for (double& v : chain.velocity) v *= units.length / units.time;
  for (double& g : chain.gap) g *= units.length;
  for (auto& law : chain.law) units.change(std::get<contact::PowerLaw>(law));
  chain.gravity *= units.length / units.time / units.time;
}

}  // namespace

model::Chain draw_row(Dice& dice, int balls, Laws laws) {
  const double masses = spread(dice), stiffnesses = spread(dice);
  return draw_row(dice, balls, laws, masses, stiffnesses);
}

model::Chain draw_row(Dice& dice, int balls, Laws laws, double mass_decades, double stiffness_decades) {
  model::Chain chain;
  for (int i = 0; i < balls; ++i) chain.mass.push_back(dice.decades(mass_decades));
  for (int j = 0; j + 1 < balls; ++j)
    chain.law.push_back(draw_law(
        dice, laws, dice.decades(stiffness_decades),
        reduced(chain.mass[static_cast<std::size_t>(j)], chain.mass[static_cast<std::size_t>(j) + 1])));
  chain.velocity.assign(chain.mass.size(), 0.0);
  chain.gap.assign(chain.law.size(), 0.0);
  return chain;
}

void draw_gaps(Dice& dice, model::Chain& chain, double share, double most) {
  for (double& gap : chain.gap) gap = dice.chance(share) ? dice.uniform(0, most) : 0;
}

void draw_velocities(Dice& dice, model::Chain& chain) {
  for (double& v : chain.velocity) v = dice.uniform(-1, 1);
}

void add_wall(model::Chain& chain, bool left, double gap, double velocity) {
  const auto put = [left](auto& list, auto value) { list.insert(left ? list.begin() : list.end(), value); };
  put(chain.mass, infinity);
  put(chain.velocity, velocity);
  put(chain.gap, gap);
  put(chain.law, contact::Law(left ? chain.law.front() : chain.law.back()));
}

double natural_time(const model::Chain& chain) {
  double longest = 0;
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    longest = std::max(longest, natural_time(chain.law[j], 1 / chain.mass[j] + 1 / chain.mass[j + 1], 1));
  return longest;
}

Scene in_some_units(Dice& dice, model::Chain chain, double max_time) {
  const Units units =
      dice.chance(0.6) ? Units{1, 1, 1} : Units{dice.decades(12), dice.decades(12), dice.decades(12)};
  change(units, chain);
  return {.model = std::move(chain), .max_time = max_time * units.time};
}

}  // namespace mariotte::stress_study
