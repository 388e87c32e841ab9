// The right-hand sides that rivals get of a body with one tip on the plane, as a user writes them, in units
// of order one: central (gap, velocity), planar (gap, angle, two velocities, spin) and spatial (gap,
// quaternion, velocity, angular momentum).
#pragma once
#include <array>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "rival.hpp"

namespace mariotte::work_precision {

/// What all three need of a body.
struct TipField {
  static constexpr double overtime = 1;  // a body that flies off goes on turning
  static constexpr std::size_t velocities = 6;

  contact::BrachDunn law;
  double mass, axial, transverse, arm, radius, friction, smoothing, speed;

  TipField() = default;
  TipField(const Case& one, const Setting& setting)
      : law(body_of(one).scaled.law[0]),
        mass(body_of(one).scaled.body.mass),
        axial(body_of(one).scaled.body.inertia.e1),
        transverse(body_of(one).scaled.body.inertia.e2),
        arm(body_of(one).scaled.body.tips[0].centre.e1),
        radius(body_of(one).scaled.body.tips[0].radius),
        friction(body_of(one).scaled.friction.coefficient),
        smoothing(setting.smoothing * body_of(one).scaled.speed),
        speed(body_of(one).scaled.speed) {}

  double normal_force(double gap, double velocity) const {
    return std::sqrt(std::max(0.0, -gap)) * contact::pressure(law, -gap, velocity);
  }
  /// Coulomb's friction per slip, with a normal force of either sign.
  double grip(double normal, double slip_square) const {
    const double size = std::sqrt(slip_square + smoothing * smoothing);
    return size > 0 ? -friction * std::abs(normal) / size : 0;
  }
  double reach() const { return std::abs(arm) + radius; }
  void put(const Vector3& velocity, const Vector3& spin, Answer& answer) const {
    const Vector3 v = (1 / speed) * velocity, w = (reach() / speed) * spin;
    answer.velocity = {v.e1, v.e2, v.e3, w.e1, w.e2, w.e3};
  }
};

struct CentralField : TipField {
  static constexpr std::size_t size = 2;
  using State = std::array<double, size>;
  using TipField::TipField;

  void start(const Case& one, double* x) const {
    x[0] = 0;
    x[1] = body_of(one).scaled.velocity.e1;
  }
  void finish(const double* x, Answer& answer) const { put({x[1], 0, 0}, {}, answer); }
  State magnitudes() const { return {1, 1}; }
  void operator()(const double* x, double* dx) const {
    dx[0] = x[1];
    dx[1] = normal_force(x[0], x[1]) / mass;
  }
};

/// In the plane of e1 and e3, turning by an angle θ about e2: the axis is (cos θ, 0, −sin θ).
struct PlanarField : TipField {
  static constexpr std::size_t size = 5;
  using State = std::array<double, size>;
  using TipField::TipField;

  void start(const Case& one, double* x) const {
    const auto& body = body_of(one).scaled;
    const Vector3 axis = rotate(body.attitude, {1, 0, 0});
    const double values[] = {0, std::atan2(-axis.e3, axis.e1), body.velocity.e1, body.velocity.e3,
                             body.momentum.e2 / transverse};
    std::copy(values, values + size, x);
  }
  void finish(const double* x, Answer& answer) const { put({x[2], 0, x[3]}, {0, x[4], 0}, answer); }
  State magnitudes() const { return {1, 1 / reach(), 1, 1, 1 / reach()}; }
  void operator()(const double* x, double* dx) const {
    const double d1 = arm * std::cos(x[1]), d3 = -arm * std::sin(x[1]), lever = d1 - radius, spin = x[4];
    const double velocity = x[2] + spin * d3, slip = x[3] - spin * lever;
    const double normal = normal_force(x[0], velocity), tangential = slip * grip(normal, slip * slip);
    dx[0] = velocity;
    dx[1] = spin;
    dx[2] = normal / mass;
    dx[3] = tangential / mass;
    dx[4] = (d3 * normal - lever * tangential) / transverse;
  }
};

/// A body with an axis of symmetry.
struct SpatialField : TipField {
  static constexpr std::size_t size = 11;
  using State = std::array<double, size>;
  using TipField::TipField;

  void start(const Case& one, double* x) const {
    const auto& [q, v, h] =
        std::tie(body_of(one).scaled.attitude, body_of(one).scaled.velocity, body_of(one).scaled.momentum);
    const double values[] = {0, q.w, q.x, q.y, q.z, v.e1, v.e2, v.e3, h.e1, h.e2, h.e3};
    std::copy(values, values + size, x);
  }
  void finish(const double* x, Answer& answer) const {
    put({x[5], x[6], x[7]}, spin({x[8], x[9], x[10]}, axis(x)), answer);
  }
  State magnitudes() const {
    const double turn = 1 / reach(), momentum = transverse / reach();
    return {1, turn, turn, turn, turn, 1, 1, 1, momentum, momentum, momentum};
  }
  static Vector3 axis(const double* x) { return rotate(Quaternion{x[1], x[2], x[3], x[4]}, {1, 0, 0}); }
  Vector3 spin(const Vector3& momentum, const Vector3& axis) const {
    return (1 / transverse) * momentum + ((1 / axial - 1 / transverse) * dot(momentum, axis)) * axis;
  }
  void operator()(const double* x, double* dx) const {
    const Vector3 a = axis(x), v{x[5], x[6], x[7]}, w = spin({x[8], x[9], x[10]}, a);
    const Vector3 lever = arm * a - radius * normal_axis, tip = v + cross(w, lever);
    const double normal = normal_force(x[0], tip.e1), hold = grip(normal, tip.e2 * tip.e2 + tip.e3 * tip.e3);
    const Vector3 force{normal, hold * tip.e2, hold * tip.e3}, moment = cross(lever, force);
    const auto turn = quaternion_rate({x[1], x[2], x[3], x[4]}, w);
    const double rates[] = {tip.e1,          turn.w,          turn.x,    turn.y,    turn.z,   force.e1 / mass,
                            force.e2 / mass, force.e3 / mass, moment.e1, moment.e2, moment.e3};
    std::copy(rates, rates + size, dx);
  }
};

/// A rival of bodies as a Solve; empty if there is no body.
template <template <class> class Rival>
Solve body_rival(const Problem& problem, const Setting& setting) {
  using Motion = flow::TipPhase::Motion;
  if (!problem.has_body()) return {};
  const auto motion = body_of(problem.cases.front()).scaled.motion;
  if (motion == Motion::normal) return solve_by<Rival<CentralField>>(setting, TipField::velocities);
  if (motion == Motion::planar) return solve_by<Rival<PlanarField>>(setting, TipField::velocities);
  return solve_by<Rival<SpatialField>>(setting, TipField::velocities);
}

/// Friction as users write it; the slip over the incident speed within which it turns about, given the
/// tolerance or step.
struct Smoothing {
  const char* suffix;
  double (*width)(double tolerance);
};
inline constexpr Smoothing smoothings[] = {{"-sgn", [](double) { return 0.0; }},
                                           {"-smoothed", [](double tolerance) { return tolerance; }},
                                           {"-smoothed-1e-3", [](double) { return 1e-3; }}};

using Prepare = Solve (*)(const Problem&, double setting);

/// A method for chains, if there is one, and bodies without friction, and one for every way of writing
/// friction.
template <template <class> class Rival>
std::vector<Method> rivals(const std::string& name, Family family, Prepare on_chain = nullptr) {
  std::vector<Method> list = {{name, family, [on_chain](const Problem& problem, double value) -> Solve {
                                 if (!problem.has_body())
                                   return on_chain ? on_chain(problem, value) : Solve();
                                 return problem.has_friction() ? Solve()
                                                               : body_rival<Rival>(problem, {value});
                               }}};
  for (const auto& smoothing : smoothings)
    list.push_back(
        {name + smoothing.suffix, family, [&, family](const Problem& problem, double value) -> Solve {
           if (!problem.has_friction()) return {};
           const double tolerance = family == Family::fixed_step ? 1 / value : value;
           return body_rival<Rival>(problem, {value, smoothing.width(tolerance)});
         }});
  return list;
}

}  // namespace mariotte::work_precision
