#include "mariotte/model/network/network.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::model {
namespace {

void validate_ball(const std::vector<Ball>& balls, std::size_t i) {
  const auto& ball = balls[i];
  const auto name = "ball " + std::to_string(i + 1) + ": ";
  const auto dimension = ball.position.size();
  if ((dimension != 2 && dimension != 3) || dimension != balls[0].position.size() ||
      ball.velocity.size() != dimension)
    throw InvalidParameter(name + "position and velocity need two values, or three, as those of ball 1");
  if (!(ball.radius > 0) || !std::isfinite(ball.radius))
    throw InvalidParameter(name + "radius must be positive and finite");
  if (!(ball.mass > 0)) throw InvalidParameter(name + "mass must be positive");
  for (std::size_t k = 0; k < dimension; ++k)
    if (!std::isfinite(ball.position[k]) || !std::isfinite(ball.velocity[k]))
      throw InvalidParameter(name + "position and velocity must be finite");
}

}  // namespace

void validate(const Network& network) {
  const Index dofs = std::ssize(network.velocity);
  if (dofs == 0) throw InvalidParameter("a network needs at least one velocity");
  if (network.direction.empty()) throw InvalidParameter("a network needs at least one contact");
  if (network.law.size() != network.direction.size() || network.gap.size() != network.direction.size())
    throw InvalidParameter("a network needs one law and one gap per contact");
  for (const double v : network.velocity)
    if (!std::isfinite(v)) throw InvalidParameter("every velocity must be finite");
  validate(network.mass, network.direction, dofs);
  for (std::size_t j = 0; j < network.law.size(); ++j) {
    validate_contact(j, network.law[j], network.gap[j], network.precompressed, "network");
    expect_no_touch(j, network.law[j], network.gap[j], gap_rate(network.direction[j], network.velocity));
  }
  const bool diagonal = is_diagonal(network.mass, dofs);  // others have no walls
  validate_drives(network.drive, network.velocity,
                  [&](Index i) { return diagonal && std::isinf(network.mass[i]); });
}

void expect_end(const Network& network, double max_time) {
  expect_end(network.drive, max_time);
}

Network as_network(const Chain& chain) {
  if (chain.gravity != 0) throw InvalidParameter("a network has no gravity");
  Network network{.mass = chain.mass,
                  .direction = {},
                  .law = chain.law,
                  .gap = chain.gap,
                  .velocity = chain.velocity,
                  .precompressed = chain.precompressed,
                  .dimension = 1,
                  .drive = chain.drive};
  for (Index j = 0; j < std::ssize(chain.law); ++j) network.direction.push_back({{j, -1}, {j + 1, 1}});
  return network;
}

Network free_balls(const std::vector<Ball>& balls) {
  Network network;
  if (!balls.empty()) network.dimension = std::ssize(balls[0].position);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    validate_ball(balls, i);
    for (const double v : balls[i].velocity) {
      network.mass.push_back(balls[i].mass);
      network.velocity.push_back(v);
    }
  }
  return network;
}

BallContact ball_contact(const std::vector<Ball>& balls, Index i, Index j) {
  const auto &a = balls[i], &b = balls[j];
  if (std::isinf(a.mass) && std::isinf(b.mass)) return {{}, 0};
  const Index dimension = std::ssize(a.position);
  double distance = 0, size = a.radius + b.radius;
  for (Index k = 0; k < dimension; ++k) {
    distance = std::hypot(distance, b.position[k] - a.position[k]);
    size = std::max({size, std::abs(a.position[k]), std::abs(b.position[k])});
  }
  if (!(distance > 0))
    throw InvalidParameter("balls " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
                           " are at the same place");
  BallContact contact{.direction = {}, .gap = distance - a.radius - b.radius, .distance = distance};
  if (std::abs(contact.gap) <= 16 * epsilon * size) contact.gap = 0;  // rounding of the positions
  for (const auto& [ball, sign] : {std::pair{i, -1.0}, {j, 1.0}})
    for (Index k = 0; k < dimension; ++k)
      contact.direction.push_back({ball * dimension + k, sign * (b.position[k] - a.position[k]) / distance});
  return contact;
}

std::optional<BallPair> balls_of(const Network& network, Index contact) {
  if (network.dimension == 0) return {};
  const auto& terms = network.direction[contact];
  return BallPair{terms.front().dof / network.dimension, terms.back().dof / network.dimension};
}

}  // namespace mariotte::model
