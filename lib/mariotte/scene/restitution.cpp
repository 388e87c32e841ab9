#include "mariotte/scene/restitution.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/bracket.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/impact/pair/pair_restitution.hpp"

namespace mariotte::scene {
namespace {

constexpr double greatest = 1e11;  // damping, a tenth of what is computed with

/// The pair as a ball and a wall, to rounding.
double simulated(impact::ChainSolver& solver, const contact::Law& law, const Encounter& encounter) {
  const model::Chain pair{
      .mass = {encounter.reduced_mass, infinity}, .law = {law}, .gap = {0}, .velocity = {encounter.speed, 0}};
  const auto& impact = solver.solve(pair, {.accuracy = 1e-13});
  return impact.ending == hybrid::Ending::bound ? 0 : -impact.velocity[0] / encounter.speed;
}

/// A sphere that strikes its plane head on.
double simulated(impact::MicrobodySolver& solver, const contact::BrachDunn& law, double radius,
                 const Encounter& encounter) {
  model::Microbody sphere;
  sphere.body = model::sphere(radius, 1);
  sphere.body = model::sphere(radius, encounter.reduced_mass / sphere.body.mass);
  sphere.velocity = {-encounter.speed, 0, 0};
  sphere.law = {law};
  const auto& impact = solver.solve(sphere, {.accuracy = 1e-12});
  return impact.ending == hybrid::Ending::captured ? 0 : impact.tip_velocity / encounter.speed;
}

/// The damping at which `restitution(damping)`, which falls from `undamped` towards 0, is the one that is
/// wanted; infinite if it is too large to be computed with.
template <class Restitution>
std::optional<double> solve(double wanted, double undamped, double unit, Restitution&& restitution) {
  const auto excess = [&](double damping) { return restitution(damping) - wanted; };
  constexpr double told = 1e-12;  // as exact as runs are
  double low = 0, above = undamped - wanted;
  if (std::abs(above) <= told) return 0;
  if (above < 0) return std::nullopt;
  for (double high = above * unit; high < greatest * unit; high *= 2) {
    const double below = excess(high);
    if (below <= 0) return locate_sign_change(excess, low, above, high, below, 1e-14 * high);
    low = high;
    above = below;
  }
  return infinity;
}

std::optional<double> dimensionless_damping(const LawChoice& law, double exponent, double wanted) {
  impact::ChainSolver solver;
  return solve(wanted, 1, 1, [&](double damping) {
    const auto made = law.make({.stiffness = 1, .exponent = exponent, .damping = damping});
    const auto closed = impact::closed_restitution({.law = made, .reduced_mass = 1}, 1);
    return closed ? *closed : simulated(solver, made, {.reduced_mass = 1, .speed = 1});
  });
}

/// Of a law that has more scales than one: the unit is the damping that changes the speed of the pair much.
std::optional<double> stated_damping(const LawChoice& law, contact::LawNumbers numbers, double wanted,
                                     const Encounter& encounter) {
  impact::ChainSolver solver;
  const auto restitution = [&](double damping) {
    numbers.damping = damping;
    return simulated(solver, law.make(numbers), encounter);
  };
  const double undamped = restitution(0);
  numbers.damping = 1;
  const auto made = std::get<contact::SharedLaw>(law.make(numbers));
  const auto& [mass, speed] = encounter;
  const double depth = made->natural_indentation(0.5 * mass * speed * speed);
  const double slope = made->force(depth, 0).by_rate;
  return solve(wanted, undamped, mass * speed / (depth * slope), restitution);
}

/// Exponent of the speed in the unit of the damping: L is a power 2/(n+1) of it, time L/v.
double speed_exponent(const Dimension& damping, double exponent) {
  return 2 / (exponent + 1) * (damping.m + damping.s) - damping.s;
}

}  // namespace

double reduced_mass(double left, double right) {
  return 1 / (1 / left + 1 / right);
}

double reduced_mass(const model::Chain& chain, Index contact) {
  return reduced_mass(chain.mass[contact], chain.mass[contact + 1]);
}

double reduced_mass(const model::Network& network, Index contact) {
  const std::vector<ContactDirection> one = {network.direction[contact]};
  const auto dofs = std::ssize(network.velocity);
  model::validate(network.mass, one, dofs);
  return 1 / dot(one[0], model::responses(network.mass, one, dofs)[0]);
}

double largest_approach(const model::Chain& chain) {
  double most = 0;
  for (std::size_t j = 1; j < chain.velocity.size(); ++j)
    most = std::max(most, chain.velocity[j - 1] - chain.velocity[j]);
  return most;
}

double largest_approach(const model::Network& network) {
  double most = 0;
  for (const auto& direction : network.direction)
    most = std::max(most, -gap_rate(direction, network.velocity));
  return most;
}

double restitution(const contact::Law& law, const Encounter& encounter) {
  impact::ChainSolver solver;
  return simulated(solver, law, encounter);
}

double restitution(const contact::BrachDunn& law, double radius, const Encounter& encounter) {
  impact::MicrobodySolver solver;
  return simulated(solver, law, radius, encounter);
}

std::optional<double> DampingSolver::damping(const LawChoice& law, const contact::LawNumbers& numbers,
                                             double restitution, const Encounter& encounter) {
  if (!law.law.find("stiffness")) return stated_damping(law, numbers, restitution, encounter);
  const double exponent = numbers.exponent;
  const auto [place, is_new] = found_.try_emplace({law.law.name, law.uncut, exponent, restitution});
  if (is_new) place->second = dimensionless_damping(law, exponent, restitution);
  if (!place->second) return std::nullopt;
  const auto& [mass, speed] = encounter;
  const auto unit = law.law.damping()->dimension(exponent);
  const double length = std::pow(mass * speed * speed / numbers.stiffness, 1 / (exponent + 1));
  return *place->second * std::pow(mass, unit.kg) * std::pow(length, unit.m) *
         std::pow(length / speed, unit.s);
}

std::optional<double> hertz_damping(const contact::Surface& surface, double radius, double damping_adhesion,
                                    double restitution, double mass, double speed) {
  impact::MicrobodySolver solver;
  const auto of_damping = [&](double damping) {
    return simulated(solver, contact::brach_dunn(surface, radius, damping, damping_adhesion), radius,
                     {.reduced_mass = mass, .speed = speed});
  };
  const bool loses = surface.adhesion > 0 && damping_adhesion > 0;  // nothing, to the last bit, without
  return solve(restitution, loses ? of_damping(0) : 1, 1 / speed, of_damping);
}

bool depends_on_speed(const contact::NamedLaw& law, double exponent) {
  const bool one_scale = law.find("stiffness");
  return !one_scale || std::abs(speed_exponent(law.damping()->dimension(exponent), exponent)) > 8 * epsilon;
}

}  // namespace mariotte::scene
