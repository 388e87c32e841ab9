#include "mariotte/impact/microbody/sphere_scene.hpp"

#include <cmath>

#include "mariotte/core/scale.hpp"
#include "mariotte/impact/gate.hpp"
#include "mariotte/impact/lane_scene.hpp"
#include "mariotte/impact/promise.hpp"
#include "mariotte/impact/slowing.hpp"

namespace mariotte::impact {
namespace {

constexpr double deepest_well = 1e3;  ///< as a speed, over that of the approach
constexpr double most_damped = 1e6;   ///< damping coefficients times the speed

bool is_at_rest(const Vector3& v) {
  return v.e1 == 0 && v.e2 == 0 && v.e3 == 0;
}

bool strikes_along_the_normal(const model::Microbody& body) {
  const auto& v = body.velocity;
  return body.impacts == 1 && body.body.tips.size() == 1 && body.gravity == 0 &&
         is_at_rest(body.body.tips[0].centre) && body.body.inertia.e1 == body.body.inertia.e2 &&
         is_symmetric(body.body) && v.e2 == 0 && v.e3 == 0 && is_at_rest(body.spin);
}

/// Mass, stiffness and speed are of order one in these units.
SphereScene scaled(const model::Microbody& body, NaturalRoot& natural_root) {
  const auto& law = body.law[0];
  const double approach = -body.velocity.e1, unit = power_of_two_below(approach), v = approach / unit;
  const double length = natural_root(body.body.mass * unit * unit / law.stiffness, 1.5);
  const double b = law.adhesion / (law.stiffness * length);
  const double well = std::sqrt(1 + 8.0 / 15 * b * b * std::sqrt(b) / (v * v));
  return {.mass = body.body.mass,
          .inertia = body.body.inertia,
          .tip = body.body.tips[0],
          .law = law,
          .friction = body.friction,
          .attitude = body.attitude,
          .lever = body.lever,
          .after_capture = body.after_capture,
          .speed = v,
          .well = well,
          .velocity = unit,
          .time = length / unit,
          .sphere = {.adhesion = b,
                     .damping_hertz = law.damping_hertz * unit,
                     .damping_adhesion = law.damping_adhesion * unit,
                     .weight = well,
                     .noise_energy = 0,
                     .rate = v}};
}

/// Energy cannot grow [microbody_gate.cpp].
bool passes_gate(const SphereScene& scene, double accuracy) {
  const auto square = [](double a) { return a * a; };
  const double gained = square(scene.sphere.rate) - square(scene.speed);
  return gained <= body_slack * accuracy * square(scene.speed) * (1 + square(scene.well));
}

}  // namespace

std::optional<SphereScene> sphere_scene(const model::Microbody& body, const hybrid::Options& options,
                                        NaturalRoot& natural_root) {
  const auto& law = body.law[0];
  if (!asks_for_accuracy_alone(options) || !strikes_along_the_normal(body) || !is_moderate(body.body.mass) ||
      !is_moderate(law.stiffness) || !is_moderate(-body.velocity.e1))
    return {};
  auto scene = scaled(body, natural_root);
  const auto& sphere = scene.sphere;
  if (!(scene.well <= deepest_well && sphere.damping_hertz <= most_damped &&
        sphere.damping_adhesion <= most_damped && options.accuracy >= 64 * epsilon * scene.well * scene.well))
    return {};
  scene.sphere.noise_energy = options.accuracy * scene.speed * scene.speed * scene.well;
  return scene;
}

void restore(const SphereScene& scene, model::Microbody& body) {
  body.body.mass = scene.mass;
  body.body.inertia = scene.inertia;
  body.body.tips[0] = scene.tip;
  body.law[0] = scene.law;
  body.friction = scene.friction;
  body.attitude = scene.attitude;
  body.velocity = {-scene.speed * scene.velocity, 0, 0};
  body.lever = scene.lever;
  body.after_capture = scene.after_capture;
}

bool describe(const SphereScene& scene, double accuracy, BriefMicrobodyImpact& impact) {
  const auto& sphere = scene.sphere;
  const Passage gone{.contacts = 1,
                     .harmless = single_impact,
                     .periods = 1,
                     .steps = sphere.steps,
                     .slowing = sphere.adhesion > 0 ? times_slower(scene.speed, -sphere.rate) : 1};
  if (!sphere.separates || may_have_erred(gone) || !passes_gate(scene, accuracy)) return false;
  const double velocity = -sphere.rate * scene.velocity;
  impact = {.ending = hybrid::Ending::separated,
            .message = {},
            .time = sphere.time * scene.time,
            .attitude = scene.attitude,
            .velocity = {velocity, 0, 0},
            .spin = {},
            .tip_velocity = velocity,
            .impacts = 1,
            .events = 2,
            .steps = sphere.steps,
            .rhs = sphere.steps,
            .estimated_accuracy = {}};
  return true;
}

}  // namespace mariotte::impact
