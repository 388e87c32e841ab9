// Random systems at an impact, for tests of impact laws: always the same ones.
#pragma once
#include <cmath>
#include <random>

#include "mariotte/impact/laws/configuration.hpp"

namespace mariotte::test {

/// 2 to 10 contacts of 2 to 10 degrees of freedom; full mass matrix, every direction on every dof.
inline impact::Configuration random_configuration(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<Index> size(2, 10);
  const Index n = size(random), m = size(random);
  impact::Configuration c;
  c.mass.assign(n * n, 0.0);
  for (Index k = 0; k < 2 * n; ++k) {  // a sum of so many squares is positive
    std::vector<double> column;
    for (Index i = 0; i < n; ++i) column.push_back(normal(random));
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j) c.mass[n * i + j] += column[i] * column[j];
  }
  c.contact.resize(m);
  for (auto& direction : c.contact)
    for (Index i = 0; i < n; ++i) direction.push_back({i, normal(random)});
  for (Index i = 0; i < n; ++i) c.velocity.push_back(normal(random));
  return c;
}

/// Largest component of M (v⁺ − v⁻) − Gᵀ p, for a full mass matrix, relative to the largest of M v⁻.
inline double momentum_residual(const impact::Configuration& c, const std::vector<double>& impulse,
                                const std::vector<double>& velocity) {
  const auto n = c.velocity.size();
  const auto given = impact::generalised_impulse(c, impulse);
  double worst = 0, scale = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double change = -given[i], before = 0;
    for (std::size_t j = 0; j < n; ++j) {
      change += c.mass[n * i + j] * (velocity[j] - c.velocity[j]);
      before += c.mass[n * i + j] * c.velocity[j];
    }
    worst = std::max(worst, std::abs(change));
    scale = std::max(scale, std::abs(before));
  }
  return worst / scale;
}

}  // namespace mariotte::test
