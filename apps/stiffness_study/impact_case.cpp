#include "impact_case.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::stiffness_study {
namespace {

contact::Law law(const ImpactCase& one, double stiffness) {
  if (one.law == "linear") return contact::Linear{stiffness};
  if (one.law == "hertz") return contact::Hertz{stiffness};
  return contact::Viscoelastic{.stiffness = stiffness, .damping = one.damping, .exponent = one.exponent};
}

/// In row i and column j of a square packing.
model::Ball moving_disk(const ImpactCase& one, Index i, Index j) {
  const double number = static_cast<double>(i * one.side + j);
  return {.position = {static_cast<double>(i), static_cast<double>(j)},
          .velocity = {one.speed * std::sin(1 + 7 * number), one.speed * std::cos(2 + 5 * number)},
          .mass = one.mass,
          .radius = 0.5};
}

/// Of a hexagonal one whose corner is struck obliquely.
model::Ball struck_disk(const ImpactCase& one, Index i, Index j) {
  const bool is_first = i == 0 && j == 0;
  return {.position = {static_cast<double>(j) + 0.5 * static_cast<double>(i % 2),
                       std::sqrt(0.75) * static_cast<double>(i)},
          .velocity = {is_first ? one.speed : 0, is_first ? 0.3 * one.speed : 0},
          .mass = one.mass,
          .radius = 0.5};
}

}  // namespace

model::Chain chain(const ImpactCase& one) {
  const auto balls = static_cast<std::size_t>(one.balls);
  model::Chain chain;
  chain.mass.assign(balls, one.mass);
  chain.gap.assign(balls - 1, 0.0);
  chain.velocity.assign(balls, 0.0);
  chain.velocity[0] = one.speed;
  for (std::size_t j = 0; j + 1 < balls; ++j)
    chain.law.push_back(law(one, j % 2 == 0 ? one.stiffness : one.ratio * one.stiffness));
  return chain;
}

model::Network packing(const ImpactCase& one) {
  std::vector<model::Ball> disks;
  for (Index i = 0; i < one.side; ++i)
    for (Index j = 0; j < one.side; ++j)
      disks.push_back(one.struck ? struck_disk(one, i, j) : moving_disk(one, i, j));
  auto network = model::ball_network(disks, one.struck ? 1e-9 : 0,
                                     [&](Index, Index) { return law(one, one.stiffness); });
  std::fill(network.gap.begin(), network.gap.end(), 0.0);
  return network;
}

double exponent(const ImpactCase& one) {
  return one.law == "linear" ? 1 : one.law == "hertz" ? 1.5 : one.exponent;
}

double natural_time(const ImpactCase& one) {
  return std::pow(one.mass * one.speed * one.speed / one.stiffness, 1 / (exponent(one) + 1)) / one.speed;
}

double damping_group(const ImpactCase& one) {
  const double n = exponent(one);
  return one.damping * std::pow(one.speed, (n - 1) / (n + 1)) * std::pow(one.stiffness, -n / (n + 1)) *
         std::pow(one.mass, -1 / (n + 1));
}

double damping_for(double ratio, double exponent) {
  return ratio * std::pow(0.5, 1 / (exponent + 1));
}

ImpactCase dimensionless(const ImpactCase& one) {
  auto unit = one;
  unit.damping = damping_group(one);
  unit.stiffness = unit.mass = unit.speed = 1;
  return unit;
}

}  // namespace mariotte::stiffness_study
