// Reference cases from tests/data/chain as chains and numbers.
#pragma once
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"

namespace mariotte::test {

using Numbers = std::vector<double>;

/// The "cases" of a file of reference numbers.
inline nlohmann::json cases(const std::string& file) {
  std::ifstream in(std::string(MARIOTTE_TEST_DATA) + "/chain/" + file);
  return nlohmann::json::parse(in).at("cases");
}

/// Balls of mass 1 touching each other, with the given laws.
inline model::Chain equal_masses(std::vector<contact::Law> laws, Numbers velocity) {
  return {.mass = Numbers(velocity.size(), 1.0),
          .law = laws,
          .gap = Numbers(laws.size(), 0.0),
          .velocity = velocity};
}

inline contact::Law undamped(const std::string& name, double stiffness) {
  if (name == "linear") return contact::Linear{stiffness};
  return contact::Hertz{stiffness};
}

inline model::Chain triplet(const nlohmann::json& c) {
  return equal_masses({undamped(c.at("law"), 1), undamped(c.at("law"), c.at("kappa"))}, c.at("velocity"));
}

inline model::Chain linear_triplet(const nlohmann::json& c) {
  return equal_masses({contact::Linear{1}, contact::Linear{c.at("kappa")}}, {1, 0, 0});
}

/// n equal Hertz balls touching at rest, struck by the first at unit speed.
inline model::Chain equal_chain(std::size_t balls) {
  Numbers velocity(balls, 0.0);
  velocity[0] = 1;
  return equal_masses(std::vector<contact::Law>(balls - 1, contact::Hertz{1}), velocity);
}

/// Balls of one material; masses and stiffnesses relative to those of two balls of radius 10.
inline model::Chain big_ball_chain(const Numbers& radius) {
  auto chain = equal_chain(radius.size());
  for (std::size_t i = 0; i < radius.size(); ++i) chain.mass[i] = std::pow(radius[i] / 10, 3);
  for (std::size_t j = 0; j + 1 < radius.size(); ++j)
    chain.law[j] =
        contact::Hertz{std::sqrt(2 * radius[j] * radius[j + 1] / (10 * (radius[j] + radius[j + 1])))};
  return chain;
}

inline contact::Law viscoelastic(const nlohmann::json& c) {
  return contact::Viscoelastic{.stiffness = 1, .damping = c.at("damping"), .exponent = c.at("exponent")};
}

/// Largest difference of two lists.
inline double difference(const Numbers& a, const Numbers& b) {
  double largest = a.size() == b.size() ? 0 : infinity;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

inline Numbers impulses(const impact::ChainImpact& impact) {
  Numbers p;
  for (const auto& contact : impact.contacts) p.push_back(contact.impulse);
  return p;
}

inline std::vector<std::size_t> period_counts(const impact::ChainImpact& impact) {
  std::vector<std::size_t> counts;
  for (const auto& contact : impact.contacts) counts.push_back(contact.periods.size());
  return counts;
}

}  // namespace mariotte::test
