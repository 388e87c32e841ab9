// A microrod strikes a plane on its tip: adhesion, damping and friction, and what its tilt does to the
// rebound.
#include <cstdio>
#include <numbers>

#include "mariotte/mariotte.hpp"

namespace {

using namespace mariotte;

/// A rod of ammonium fluorescein, ten times as long as its radius, on silicon.
model::Microbody rod(double speed, double tilt) {
  constexpr double radius = 2.45e-6, density = 1350;
  const contact::Surface surface{.stiffness = 1.74e9, .adhesion = 0.38};
  const auto law =
      contact::brach_dunn(surface, radius, contact::hertz_damping(1.5, surface, radius, density, speed),
                          contact::adhesion_damping(0.5, surface, radius, density, speed));
  return {.body = model::rod(radius, 10, density),
          .law = {law, law},  // one per tip
          .friction = {0.15},
          .attitude = from_euler({0, tilt, 0}),
          .velocity = {-speed, 0, 0},
          .spin = {},
          .impacts = 1};
}

}  // namespace

int main() {
  std::printf("tilt   e of the tip  e of the centre  lost to friction  capture velocity\n");
  for (const double degrees : {0.0, 20.0, 45.0, 70.0}) {
    const double tilt = degrees * std::numbers::pi / 180;
    const auto impact = impact::simulate(rod(5, tilt));
    const auto slow = impact::capture_velocity([&](double v) { return rod(v, tilt); }, 1, 1e-6);
    std::printf("%4.0f  %13.10f  %15.10f  %15.2f%%  %11.5f m/s\n", degrees, impact.restitution.tip,
                impact.restitution.centre, 100 * impact.energy.friction / impact.energy.initial,
                slow->value());
  }
}
