#include "mariotte/model/microbody/dimensionless_microbody.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/representable.hpp"

namespace mariotte::model {

using Motion = flow::TipPhase::Motion;

namespace {

/// Angular momentum R I Rᵀ ω.
Vector3 angular_momentum(const RigidBody& body, const Quaternion& attitude, const Vector3& spin) {
  const Vector3 w = rotate(conjugate(attitude), spin);
  return rotate(attitude, {body.inertia.e1 * w.e1, body.inertia.e2 * w.e2, body.inertia.e3 * w.e3});
}

double depth_of_well(const contact::BrachDunn& law) {
  return -contact::stored_energy(law, contact::rest_indentation(law));
}

double incident_speed(const Microbody& body) {
  const Vector3 tip = cross(body.spin, rotate(body.attitude, body.body.tips[0].centre));
  return std::max(norm(body.velocity), norm(body.velocity + tip));
}

/// Contact happens at the incident speed, or at what the well of adhesion adds to a slow body.
double natural_speed(const Microbody& body) {
  const double v = incident_speed(body);
  return std::sqrt(v * v + 2 * depth_of_well(body.law[0]) / body.body.mass);
}

Scale choose_scale(const Microbody& body) {
  Scale scale;
  scale.mass = power_of_two_below(body.body.mass);
  scale.velocity = power_of_two_below(natural_speed(body));
  scale.length = natural_root(scale.energy() / body.law[0].stiffness, 1.5);
  scale.time = scale.length / scale.velocity;
  return scale;
}

contact::BrachDunn scaled(const contact::BrachDunn& law, const Scale& scale, double reference) {
  return {.stiffness = law.stiffness / reference,
          .adhesion = law.adhesion / (reference * scale.length),
          .damping_hertz = law.damping_hertz * scale.velocity,
          .damping_adhesion = law.damping_adhesion * scale.velocity};
}

RigidBody scaled(const RigidBody& body, const Scale& scale, std::size_t tips) {
  const double inertia = scale.mass * scale.length * scale.length;
  RigidBody result{.mass = body.mass / scale.mass, .inertia = (1 / inertia) * body.inertia, .tips = {}};
  for (std::size_t i = 0; i < tips; ++i)
    result.tips.push_back(
        {.centre = (1 / scale.length) * body.tips[i].centre, .radius = body.tips[i].radius / scale.length});
  return result;
}

/// The first of these that is no rounding error, as a direction in the plane.
Vector3 leading_tangent(const DimensionlessMicrobody& d, double noise) {
  const double reach = norm(d.body.tips[0].centre) + d.body.tips[0].radius;
  const Vector3 axis = rotate(d.attitude, {1, 0, 0});
  const Vector3 turning = (1 / (d.body.inertia.e1 * d.speed)) * reach * cross(d.momentum, normal_axis);
  for (const Vector3& one :
       {tangential(reach / d.body.tips[0].radius * axis), tangential((1 / d.speed) * d.velocity), turning})
    if (norm(one) > noise) return (1 / norm(one)) * one;
  return {0, 0, 1};
}

/// Decide what can move, and take the rounding errors off the rest.
void find_motion(DimensionlessMicrobody& d) {
  constexpr double noise = 16 * epsilon;
  const double reach = norm(d.body.tips[0].centre) + d.body.tips[0].radius;
  const double momentum = d.body.inertia.e1 * d.speed / reach;
  d.tangent = leading_tangent(d, noise);
  d.axis = cross(d.tangent, normal_axis);
  if (!d.symmetric) return;
  const bool is_sphere = d.body.inertia.e1 == d.body.inertia.e2;
  const Vector3 body_axis = rotate(d.attitude, {1, 0, 0});
  const bool untilted = is_sphere && d.body.tips[0].centre == Vector3{};
  const auto out_of_plane = [&](const Vector3& v) { return std::abs(dot(v, d.axis)); };
  const bool planar = (untilted || out_of_plane(body_axis) <= noise) &&
                      out_of_plane(d.velocity) <= noise * d.speed &&
                      norm(d.momentum - dot(d.momentum, d.axis) * d.axis) <= noise * momentum;
  if (!planar) return;
  d.motion = Motion::planar;
  d.momentum = dot(d.momentum, d.axis) * d.axis;
  d.velocity = d.velocity.e1 * normal_axis + dot(d.velocity, d.tangent) * d.tangent;
  const bool central = untilted || norm(tangential(body_axis)) <= noise;
  if (!central || norm(tangential(d.velocity)) > noise * d.speed || norm(d.momentum) > noise * momentum)
    return;
  d.motion = Motion::normal;
  d.velocity = d.velocity.e1 * normal_axis;
  d.momentum = {};
}

/// Gap of tip i while the first one touches; what is below rounding touches as well.
double start_gap(const Microbody& body, std::size_t i) {
  const auto &first = body.body.tips[0], &tip = body.body.tips[i];
  const Vector3 apart = tip.centre - first.centre;
  const double gap = rotate(body.attitude, apart).e1 - tip.radius + first.radius;
  return gap > 8 * epsilon * norm(apart) ? gap : 0;
}

/// In units in which a stiffness `reference` is 1.
DimensionlessMicrobody in_units(const Microbody& body, const Scale& scale, double reference) {
  DimensionlessMicrobody d;
  d.scale = scale;
  d.body = scaled(body.body, scale, body.impacts == 1 ? 1 : body.body.tips.size());
  for (std::size_t i = 0; i < d.tips(); ++i) {
    d.law.push_back(scaled(body.law[i], scale, reference));
    d.gap.push_back(start_gap(body, i) / scale.length);
  }
  d.friction = body.friction;
  d.attitude = body.attitude;
  d.velocity = (1 / scale.velocity) * body.velocity;
  d.momentum = angular_momentum(d.body, d.attitude, scale.time * body.spin);
  d.gravity = body.gravity * scale.time / scale.velocity;
  d.lever = body.lever;
  d.impacts = body.impacts;
  d.after_capture = body.after_capture;
  d.speed = incident_speed(body) / scale.velocity;
  d.time = scale.velocity / natural_speed(body);
  d.symmetric = is_symmetric(body.body);
  return d;
}

}  // namespace

DimensionlessMicrobody dimensionless(const Microbody& body) {
  auto d = in_units(body, choose_scale(body), body.law[0].stiffness);
  expect_representable(body, d);
  find_motion(d);
  return d;
}

DimensionlessMicrobody restated(const Microbody& body, const DimensionlessMicrobody& base) {
  const auto& scale = base.scale;
  const double reference = scale.energy() / (scale.length * scale.length * std::sqrt(scale.length));
  auto d = in_units(body, scale, reference);
  d.motion = Motion::spatial;
  return d;
}

bool can_swing(const DimensionlessMicrobody& body) {
  return body.motion != Motion::normal && !(body.body.tips[0].centre == Vector3{});
}

double reachable_accuracy(const DimensionlessMicrobody& body, double asked) {
  constexpr double coarsest = 0.1;
  const double in_the_well = 1 / (body.time * body.speed);
  return std::max(asked / in_the_well, std::min(64 * epsilon * in_the_well, coarsest));
}

}  // namespace mariotte::model
