// A contact law of one's own, f = k δ², as a rough cone makes it: hand force, slopes and energy to a chain.
#include <cmath>
#include <cstdio>

#include "mariotte/impact/chain/chain_impact.hpp"

namespace {

using namespace mariotte;

/// Two bodies that press a cone flat.
class Cone final : public contact::CustomLaw {
 public:
  explicit Cone(double stiffness) : stiffness_(stiffness) {}
  std::string_view name() const override { return "cone"; }
  contact::Force force(double indentation, double /*rate*/) const override {
    const double slope = stiffness_ * indentation;
    return {.value = slope * indentation, .by_indentation = 2 * slope, .by_rate = 0};
  }
  double stored_energy(double indentation) const override {
    return stiffness_ * indentation * indentation * indentation / 3;
  }

 private:
  double stiffness_;  ///< k [N/m²]
};

/// A number of the simulation beside its closed form; true if they agree.
bool compare(const char* what, double value, double expected) {
  std::printf("%-17s %.10f  %.10f\n", what, value, expected);
  return std::abs(value - expected) < 1e-8 * expected;  // a hundred times the accuracy asked for
}

}  // namespace

int main() {
  constexpr double mass = 0.5, speed = 2, stiffness = 7;
  const auto cone = std::make_shared<Cone>(stiffness);
  const auto rebound = impact::simulate(
      {.mass = {infinity, mass}, .law = {cone}, .gap = {0}, .velocity = {0, -speed}}, {.accuracy = 1e-10});
  // k δ³/3 = m v²/2 at the turn; the time there and back is 2 δ/v ∫ du/√(1 − u³).
  const double depth = std::cbrt(1.5 * mass * speed * speed / stiffness);
  const double integral = std::sqrt(std::acos(-1.0)) * std::tgamma(4.0 / 3) / std::tgamma(5.0 / 6);
  std::printf("                  simulated     closed form\n");
  bool agrees = compare("speed [m/s]", rebound.velocity[1], speed);
  agrees &= compare("indentation [m]", rebound.contacts[0].peak_indentation, depth);
  agrees &= compare("duration [s]", rebound.time, 2 * depth / speed * integral);

  // The same law in a row, beside a Hertz contact.
  const auto row = impact::simulate(
      {.mass = {1, 1, 1}, .law = {cone, contact::Hertz{stiffness}}, .gap = {0, 0}, .velocity = {1, 0, 0}});
  std::printf("\nthree balls: %.6f %.6f %.6f m/s\n", row.velocity[0], row.velocity[1], row.velocity[2]);
  return agrees ? 0 : 1;
}
