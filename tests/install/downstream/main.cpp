// A user's program: three equal balls, one impact, momentum kept.
#include <cmath>
#include <cstdio>

#include "mariotte/impact/chain/chain_impact.hpp"

int main() {
  using mariotte::contact::Hertz;
  const mariotte::model::Chain chain{
      .mass = {1, 1, 1},
      .law = {Hertz{.stiffness = 1}, Hertz{.stiffness = 1}},
      .gap = {0, 0},
      .velocity = {1, 0, 0},
  };
  const auto impact = mariotte::impact::simulate(chain);
  const double momentum = impact.velocity[0] + impact.velocity[1] + impact.velocity[2];
  std::printf("%s, momentum %.17g\n", mariotte::hybrid::name(impact.ending), momentum);
  const bool separated = impact.ending == mariotte::hybrid::Ending::separated;
  return separated && std::abs(momentum - 1) < 1e-9 ? 0 : 1;
}
