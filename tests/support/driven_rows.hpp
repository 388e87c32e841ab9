// Rows behind walls that move, and forces on them.
#pragma once
#include <utility>
#include <vector>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::test {

inline model::Drive drive(Index ball, model::Driven quantity, model::Signal signal) {
  return {.direction = {{ball, 1.0}}, .quantity = quantity, .signal = std::move(signal)};
}

/// A wall and balls of mass 1 at rest behind it, touching.
inline model::Chain row_behind_wall(std::vector<contact::Law> law, model::Drive one) {
  model::Chain chain{.mass = std::vector<double>(law.size() + 1, 1.0),
                     .law = std::move(law),
                     .gap = {},
                     .velocity = {},
                     .drive = {one}};
  chain.gap.assign(chain.law.size(), 0.0);
  chain.velocity.assign(chain.mass.size(), 0.0);
  chain.mass[0] = infinity;
  chain.velocity[0] = start_velocity(one);
  return chain;
}

inline hybrid::Options until(double time, double accuracy = 1e-10) {
  return {.accuracy = accuracy, .max_time = time, .flies_on = true};
}

}  // namespace mariotte::test
