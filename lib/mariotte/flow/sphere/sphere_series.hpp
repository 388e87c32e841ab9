// Spheres side by side; compiled once per instruction set.
#pragma once
#include "mariotte/flow/lanes/lane_step.hpp"
#include "mariotte/flow/lanes/side_by_side.hpp"
#include "mariotte/flow/sphere/sphere_field.hpp"
#include "mariotte/flow/sphere/sphere_lanes.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// A step of spheres in contact, one in each lane.
class SphereStep : public LaneStep<SphereField> {
  using Base = LaneStep<SphereField>;
  using Field = SphereField;

 public:
  using Scene = Sphere;
  static constexpr Sphere idle{
      .adhesion = 0, .damping_hertz = 0, .damping_adhesion = 0, .weight = 1, .noise_energy = 0, .rate = 0};

  void load(int scene, const Sphere& sphere) {
    Base::load(scene, Field::root, 0, 0);
    Base::load(scene, Field::rate, 0, sphere.rate);
    Base::load(scene, Field::time, 0, 0);
    Base::load_parameter(scene, Field::adhesion, 0, sphere.adhesion);
    Base::load_parameter(scene, Field::damping_hertz, 0, sphere.damping_hertz);
    Base::load_parameter(scene, Field::damping_adhesion, 0, sphere.damping_adhesion);
    Base::load_weights(scene, 0, sphere.weight, sphere.weight);
    Base::set(adhesion_, 0, scene, sphere.adhesion);
    Base::set(noise_, 0, scene, sphere.noise_energy);
  }

  void advance(const Precision& precision) {
    Base::advance(precision);
    const Vec s = Base::state(Field::root), rate = Base::state(Field::rate), area = s * s;
    energy_ = 0.5 * rate * rate + s * area * (0.4 * area - 2.0 / 3 * adhesion_.part[0]) - noise_.part[0];
    clearance_ = least(energy_, Base::bound(0));
  }

  /// It stays in contact all the while, and has the energy to leave.
  bool is_clear(int scene) const { return clearance_[scene] > 0; }
  /// Damping takes energy, so that what has it now had it before: the sphere has not turned back on its way
  /// out, which it does only where its energy is less than 0.
  bool can_leave(int scene) const { return energy_[scene] > 0; }

  void put(int scene, double place, Sphere& sphere) const {
    sphere.rate = Base::value(scene, Field::rate, 0, place);
    sphere.time = Base::value(scene, Field::time, 0, place);
  }

 private:
  Number adhesion_, noise_;
  Vec clearance_, energy_;
};

class SphereSeries final : public SphereLanes {
 public:
  void follow(std::span<Sphere* const> spheres, const Precision& precision) override {
    lanes_.follow(spheres, precision, [&](int lane, Sphere& s, int steps) { return look(lane, s, steps); });
  }

 private:
  /// It may have left within the step, or will not for want of energy.
  Look look(int lane, Sphere& sphere, int steps) const {
    const auto& step = lanes_.step();
    const double end = step.end(lane);
    const auto fall = step.remains(lane, 0) ? std::nullopt : step.first_fall(lane, 0, end);
    if (!fall && step.can_leave(lane) && !lanes_.is_over(steps)) return Look::goes_on;
    sphere.steps = steps;
    step.put(lane, fall.value_or(end), sphere);
    sphere.separates = fall && sphere.rate < 0 && 0.5 * sphere.rate * sphere.rate > sphere.noise_energy;
    return Look::ended;
  }

  SideBySide<SphereStep> lanes_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::flow::SphereLanes> mariotte::flow::MARIOTTE_INSTRUCTION_SET::make_sphere_lanes() {
  return std::make_unique<taylor::MARIOTTE_INSTRUCTION_SET::SphereSeries>();
}
