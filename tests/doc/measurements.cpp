// Prints apps/scenes/sphere_fit.csv: what a scene predicts at the default parameters of [Cheng 2002], with
// noise of a stated size.
#include <cmath>
#include <cstdio>

#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "support/noise.hpp"

using namespace mariotte;

namespace {

constexpr double diameters[] = {4.90, 6.89};  // [µm]
constexpr int speeds = 15;
constexpr double slowest = 2.5, fastest = 20;  // [m/s]
constexpr double deviation = 0.01;
constexpr std::uint64_t seed = 2;

double restitution(double radius, double speed) {
  constexpr contact::Surface surface{.stiffness = 1.74e9, .adhesion = 0.38};
  constexpr double density = 1350, zeta_hertz = 1.5, zeta_adhesion = 0.5;
  model::Microbody body;
  body.body = model::sphere(radius, density);
  body.law = {contact::brach_dunn(surface, radius,
                                  contact::hertz_damping(zeta_hertz, surface, radius, density, speed),
                                  contact::adhesion_damping(zeta_adhesion, surface, radius, density, speed))};
  body.velocity = {-speed, 0, 0};
  return impact::simulate(body).restitution.tip;
}

}  // namespace

int main() {
  std::printf(
      "# Synthetic, not measured: zeta_hertz = 1.5, zeta_adhesion = 0.5 and normally distributed noise\n"
      "# with a standard deviation of %g, seed %d, printed by build/tests/doc/doc_measurements.\n"
      "diameter [um],speed [m/s],restitution,deviation\n",
      deviation, static_cast<int>(seed));
  int row = 0;
  for (const double diameter : diameters)
    for (int i = 0; i < speeds; ++i, ++row) {
      const double speed = 0.01 * std::round(100 * slowest * std::pow(fastest / slowest, i / (speeds - 1.0)));
      const double e = restitution(0.5e-6 * diameter, speed) + deviation * test::normal(seed, row);
      std::printf("%.2f,%.2f,%.4f,%g\n", diameter, speed, e, deviation);
    }
}
