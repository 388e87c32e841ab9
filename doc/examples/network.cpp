// Impacts of anything with a mass matrix and contacts: Bernoulli's ball that strikes two, a rack of fifteen
// balls, and a block that comes down on one edge and rests on the other, in coordinates of its own.
#include <cmath>
#include <cstdio>

#include "mariotte/mariotte.hpp"

namespace {

using namespace mariotte;

contact::Law steel(Index, Index) {
  return contact::Hertz{1e10};
}

void show(const char* what, const impact::NetworkImpact& impact) {
  const bool closed = std::abs(impact.energy.residual) < 1e-9 * impact.energy.initial;
  std::printf("%s: %s, energy balance %s\n", what, hybrid::name(impact.ending), closed ? "closed" : "open");
}

/// Balls of radius 10 mm in the plane; the first moves along x, the others rest.
model::Ball ball(double x, double y, double speed = 0) {
  return {.position = {0.02 * x, 0.02 * y}, .velocity = {speed, 0}, .mass = 0.033, .radius = 0.01};
}

}  // namespace

int main() {
  const double row = std::sqrt(3.0) / 2;
  const auto one_on_two = model::ball_network({ball(-row, 0, 1), ball(0, 0.5), ball(0, -0.5)}, 0, steel);
  const auto bernoulli = impact::simulate(one_on_two);
  show("one on two", bernoulli);
  for (std::size_t i = 0; i < 6; i += 2)
    std::printf("  (%8.5f, %8.5f)\n", bernoulli.velocity[i], bernoulli.velocity[i + 1]);

  std::vector<model::Ball> balls = {ball(-1, 0.05, 1)};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j <= i; ++j) balls.push_back(ball(row * i, j - 0.5 * i));
  const auto rack = model::ball_network(balls, 1e-3, steel);
  const auto broken = impact::simulate(rack);
  std::printf("%zu balls, %zu contacts\n", balls.size(), rack.law.size());
  show("rack", broken);
  std::printf("  a corner leaves with (%.5f, %.5f)\n", broken.velocity[30], broken.velocity[31]);

  // v = (height rate, spin) of a block 0.2 m wide that comes down on its left edge and rests on the right
  // one.
  const model::Network block{.mass = {5, 0.0208},
                             .direction = {{{0, 1}, {1, -0.1}}, {{0, 1}, {1, 0.1}}},
                             .law = {contact::Viscoelastic{1e9, 3e3, 1}, contact::Viscoelastic{1e9, 3e3, 1}},
                             .gap = {0, 0},
                             .velocity = {-0.1, 1}};
  const auto rocking = impact::simulate(block);
  show("rocking block", rocking);
  std::printf("  spin %.5f -> %.5f, impulses %.5f and %.5f N s\n", block.velocity[1], rocking.velocity[1],
              rocking.contacts[0].impulse, rocking.contacts[1].impulse);
}
