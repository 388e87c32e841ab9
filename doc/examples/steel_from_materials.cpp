// Balls of real size: masses and Hertz stiffnesses follow from radii and material, all in SI units.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "mariotte/mariotte.hpp"

int main() {
  using namespace mariotte;
  const contact::Elasticity steel{.young = 210e9, .poisson = 0.3};
  const double density = 7800;

  model::Chain chain{.mass = {}, .law = {}, .gap = {0, 0}, .velocity = {1, 0, 0}};
  const double radius[] = {0.010, 0.050, 0.010};
  for (const double r : radius) chain.mass.push_back(4.0 / 3.0 * std::numbers::pi * std::pow(r, 3) * density);
  for (int j = 0; j < 2; ++j) {
    const double stiffness = contact::hertz_stiffness(steel, radius[j], steel, radius[j + 1]);
    chain.law.push_back(contact::Hertz{stiffness});
  }
  const auto impact = impact::simulate(chain);

  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    const auto& contact = impact.contacts[j];
    std::printf("contact %zu: k = %.5g N/m^1.5, impulse %.6f mN s, peak force %.2f N, indentation %.4f µm\n",
                j + 1, contact::stiffness(chain.law[j]), 1e3 * contact.impulse, contact.peak_force,
                1e6 * contact.peak_indentation);
  }
  std::printf("impulse correlation ratio %.6f after %.3f µs\n", *impact.icr[0], 1e6 * impact.time);
}
