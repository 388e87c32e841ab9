// Random chains for property tests: always the same ones.
#pragma once
#include <cmath>
#include <random>

#include "mariotte/model/chain/chain.hpp"

namespace mariotte::test {

/// n ≤ 12 balls, masses over 2 decades, stiffnesses over 4, mixed laws, gaps on half of the contacts, random
/// velocities.
inline model::Chain random_chain(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto decades = [&](double count) { return std::pow(10.0, uniform(-count / 2, count / 2)); };
  const int balls = std::uniform_int_distribution(2, 12)(random);
  model::Chain chain;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(decades(2));
    chain.velocity.push_back(uniform(-1, 1));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(uniform(0, 1) < 0.5 ? 0 : uniform(0, 2));
    const double stiffness = decades(4);
    switch (std::uniform_int_distribution(0, 3)(random)) {
      case 0:
        chain.law.push_back(contact::Linear{stiffness});
        break;
      case 1:
        chain.law.push_back(contact::Hertz{stiffness});
        break;
      case 2:
        chain.law.push_back(contact::Viscoelastic{stiffness, decades(2) * std::sqrt(stiffness), 1.5});
        break;
      default:
        chain.law.push_back(contact::Viscoelastic{stiffness, decades(2) * std::sqrt(stiffness), 1});
    }
  }
  return chain;
}

/// The kinds of chain whose corners differ.
enum class Kind { plain, touching_at_rest, falling_on_a_wall, between_walls, equal_and_touching };
inline constexpr Kind kinds[] = {Kind::plain, Kind::touching_at_rest, Kind::falling_on_a_wall,
                                 Kind::between_walls, Kind::equal_and_touching};

inline model::Chain random_chain(std::mt19937_64& random, Kind kind) {
  auto chain = random_chain(random);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto fix = [&](std::size_t ball) {
    chain.mass[ball] = infinity;
    chain.velocity[ball] = 0;
  };
  switch (kind) {
    case Kind::plain:
      break;
    case Kind::touching_at_rest:
      chain.velocity.assign(chain.velocity.size(), 0.0);
      chain.velocity[0] = 1;
      chain.gap.assign(chain.gap.size(), 0.0);
      break;
    case Kind::falling_on_a_wall:
      fix(0);
      chain.gravity = uniform(0, 1);
      break;
    case Kind::between_walls:
      fix(0);
      fix(chain.mass.size() - 1);
      break;
    case Kind::equal_and_touching:  // many events at one instant, many velocities exactly equal
      chain.mass.assign(chain.mass.size(), 1.0);
      chain.gap.assign(chain.gap.size(), 0.0);
      for (double& v : chain.velocity) v = std::round(2 * v) / 2;
      for (auto& law : chain.law)
        law = uniform(0, 1) < 0.5 ? contact::Law(contact::Hertz{1}) : contact::Law(contact::Linear{1});
  }
  return chain;
}

}  // namespace mariotte::test
