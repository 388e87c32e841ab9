// Spheres side by side; compiled once per instruction set.
#pragma once
#include "mariotte/flow/lanes/side_by_side.hpp"
#include "mariotte/flow/sphere/sphere_lanes.hpp"
#include "mariotte/flow/sphere/sphere_step.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

class SphereSeries final : public SphereLanes {
 public:
  void follow(std::span<Sphere* const> spheres, const Precision& precision) override {
    lanes_.follow(spheres, precision, [&](int lane, Sphere& s, int steps) { return ends(lane, s, steps); });
  }

 private:
  /// It may have left within the step, or will not for want of energy.
  bool ends(int lane, Sphere& sphere, int steps) const {
    const auto& step = lanes_.step();
    const double end = step.end(lane);
    const auto fall = step.remains(lane, 0) ? std::nullopt : step.first_fall(lane, 0, end);
    if (!fall && step.can_leave(lane) && !lanes_.is_over(steps)) return false;
    sphere.steps = steps;
    step.put(lane, fall.value_or(end), sphere);
    sphere.separates = fall && sphere.rate < 0 && 0.5 * sphere.rate * sphere.rate > sphere.noise_energy;
    return true;
  }

  SideBySide<SphereStep> lanes_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::flow::SphereLanes> mariotte::flow::MARIOTTE_INSTRUCTION_SET::make_sphere_lanes() {
  return std::make_unique<taylor::MARIOTTE_INSTRUCTION_SET::SphereSeries>();
}
