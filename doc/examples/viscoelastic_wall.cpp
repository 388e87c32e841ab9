// A ball against a wall, f = max(0, k δ^{3/2} + c δ^{1/2} δ̇): how much speed is left, and where the energy went.
#include <cstdio>

#include "mariotte/impact/chain_impact.hpp"

int main() {
  using namespace mariotte;
  std::printf("damping  restitution   energy lost  let go at δ > 0\n");
  for (const double damping : {0.0, 0.1, 0.3, 1.0, 3.0}) {
    const contact::Viscoelastic law{.stiffness = 1, .damping = damping, .exponent = 1.5};
    const model::Chain chain{.mass = {infinity, 1}, .law = {law}, .gap = {0}, .velocity = {0, -1}};
    const auto impact = impact::simulate(chain);
    // A damped contact stops pushing while it is still indented, and the run ends there: the wall cannot pull.
    const bool indented = impact.gap[0] < 0;
    std::printf("%7.1f  %11.8f  %12.8f  %s\n", damping, impact.velocity[1], impact.energy.dissipated,
                damping > 0 && indented ? "yes" : "no");
  }
}
