#include <cmath>
#include <numbers>

#include "chain_parts.hpp"
#include "family.hpp"

namespace mariotte::stress_study {
namespace {

/// A sum of so many squares is positive definite.
model::MassMatrix full_mass(Dice& dice, std::size_t n) {
  model::MassMatrix mass(n * n, 0.0);
  for (std::size_t k = 0; k < 2 * n; ++k) {
    std::vector<double> column;
    for (std::size_t i = 0; i < n; ++i) column.push_back(dice.uniform(-1, 1));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) mass[n * i + j] += column[i] * column[j];
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) mass[n * i + j] = mass[n * j + i];
  return mass;
}

/// All contacts open along one common motion, so that none is trapped.
ContactDirection open_direction(Dice& dice, std::size_t n) {
  ContactDirection direction;
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    direction.push_back({static_cast<Index>(i), dice.uniform(-1, 1)});
    sum += direction.back().coefficient;
  }
  if (sum < 0)
    for (auto& term : direction) term.coefficient = -term.coefficient;
  return direction;
}

Scene any_network(Dice& dice) {
  const auto n = static_cast<std::size_t>(dice.whole(2, 8));
  const int contacts = dice.whole(1, 8);
  const auto laws = any_laws(dice);
  model::Network network;
  network.mass = dice.chance(0.5) ? full_mass(dice, n) : model::MassMatrix(n, 1.0);
  for (std::size_t i = 0; i < n; ++i) network.velocity.push_back(dice.uniform(-1, 1));
  const double decades = spread(dice) / 2;
  for (int j = 0; j < contacts; ++j) {
    network.direction.push_back(open_direction(dice, n));
    network.law.push_back(draw_law(dice, laws, dice.decades(decades), 1));
    network.gap.push_back(dice.chance(0.5) ? 0 : dice.uniform(0, 0.3));
  }
  return {.model = std::move(network), .max_time = 200};
}

/// Balls on a triangular lattice of unit spacing, touching to rounding, row by row behind the first.
std::vector<model::Ball> rack(Dice& dice, int rows, bool equal) {
  std::vector<model::Ball> balls;
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k <= row; ++k)
      balls.push_back({.position = {row * std::sqrt(0.75), k - 0.5 * row},
                       .velocity = {0, 0},
                       .mass = equal ? 1 : dice.decades(1),
                       .radius = 0.5});
  return balls;
}

Scene struck_rack(Dice& dice) {
  auto balls = rack(dice, dice.whole(1, 4), dice.chance(0.6));
  const double angle = dice.chance(0.3) ? 0 : dice.uniform(-0.9, 0.9), away = dice.pick({1, 1.1});
  balls.push_back({.position = {-away * std::cos(angle), away * std::sin(angle)},
                   .velocity = {1, dice.chance(0.5) ? 0 : dice.uniform(-0.5, 0.5)},
                   .mass = dice.decades(1),
                   .radius = 0.5});
  const auto laws = any_laws(dice);
  const double decades = dice.pick({0, 1});
  auto network = model::ball_network(
      balls, 0.2, [&](Index, Index) { return draw_law(dice, laws, dice.decades(decades), 0.5); });
  return {.model = std::move(network), .max_time = 300};
}

/// A square of touching balls in a corner of two heavy rows.
Scene corner(Dice& dice) {
  std::vector<model::Ball> balls;
  const int side = dice.whole(2, 3);
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j)
      if (i + j > 0)
        balls.push_back({.position = {1.0 * i, 1.0 * j},
                         .velocity = {i && j ? dice.uniform(-1, 0.2) : 0, i && j ? dice.uniform(-1, 0.2) : 0},
                         .mass = i && j ? 1 : infinity,
                         .radius = 0.5});
  const auto laws = any_laws(dice);
  auto network = model::ball_network(balls, 0.1, [&](Index, Index) { return draw_law(dice, laws, 1, 0.5); });
  return {.model = std::move(network), .max_time = dice.uniform(2, 10)};
}

Scene rocking_block(Dice& dice) {
  const double width = dice.uniform(0.05, 1);
  model::Network network{.mass = {1, dice.between(0.01, 1)},
                         .direction = {{{0, 1}, {1, -width}}, {{0, 1}, {1, width}}},
                         .law = {},
                         .gap = {0, dice.pick({0, dice.uniform(0, 0.1)})},
                         .velocity = {-dice.uniform(0, 1), dice.uniform(-1, 1)}};
  const auto laws = any_laws(dice);
  for (int j = 0; j < 2; ++j) network.law.push_back(draw_law(dice, laws, dice.decades(1), 1));
  return {.model = std::move(network)};
}

Scene chain_as_network(Dice& dice) {
  auto chain = draw_row(dice, dice.whole(2, 6), any_laws(dice));
  draw_velocities(dice, chain);
  draw_gaps(dice, chain, 0.4, 1);
  if (dice.chance(0.2)) add_wall(chain, true, dice.uniform(0, 1));
  return {.model = model::as_network(chain)};
}

Scene precompressed(Dice& dice) {
  auto scene = any_network(dice);
  auto& network = std::get<model::Network>(scene.model);
  network.precompressed = true;
  for (double& gap : network.gap) gap = dice.chance(0.6) ? -dice.between(1e-2, 1) : gap;
  return scene;
}

}  // namespace

std::vector<Family> network_families() {
  return {{"any network", any_network},
          {"struck rack", struck_rack},
          {"corner", corner, 10},
          {"rocking block", rocking_block},
          {"chain as network", chain_as_network},
          {"precompressed network", precompressed}};
}

}  // namespace mariotte::stress_study
