// A ball and a wall with f = max(0, k δ^{3/2} + c δ^{1/2} δ̇): what speed is left, and where the energy goes.
#include <algorithm>
#include <cstdio>

#include "mariotte/mariotte.hpp"

int main() {
  using namespace mariotte;
  std::printf("damping  restitution  energy lost  duration  indentation left\n");
  for (const double damping : {0.0, 0.1, 0.3, 1.0, 3.0}) {
    const contact::Viscoelastic law{.stiffness = 1, .damping = damping, .exponent = 1.5};
    const model::Chain chain{.mass = {infinity, 1}, .law = {law}, .gap = {0}, .velocity = {0, -1}};
    const auto impact = impact::simulate(chain);
    // A damped contact lets go while it is still indented, since it cannot pull; the ball then flies freely.
    const double indentation = std::max(0.0, -impact.gap[0]);
    std::printf("%7.1f  %11.8f  %11.8f  %8.5f  %16.6f\n", damping, impact.velocity[1],
                impact.energy.dissipated, impact.time, indentation);
  }
}
