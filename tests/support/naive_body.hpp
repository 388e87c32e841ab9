// A microbody for the naive simulator: force and friction as they stand in the books, friction smoothed near
// rest, no events. Good to about 1e-7 without friction, and to the smoothing with it.
#pragma once
#include <array>

#include "mariotte/model/microbody/microbody.hpp"
#include "support/naive_steps.hpp"

namespace mariotte::test {

/// Height, attitude, velocity and angular momentum in units of the natural depth and of `speed`.
class NaiveBody {
 public:
  using State = std::vector<double>;

  NaiveBody(const model::Microbody& body, double speed, const Effort& effort)
      : body_(body), speed_(speed), effort_(effort) {
    const auto& tip = body.body.tips[0];
    reach_ = norm(tip.centre) + tip.radius;
    depth_ = std::pow(body.body.mass * speed * speed / body.law[0].stiffness, 0.4);
    inertia_ = std::max({body.body.inertia.e1, body.body.inertia.e2, body.body.inertia.e3});
    turn_ = reach_ / depth_;
    momentum_ = inertia_ * speed / reach_;
  }

  State start() const {
    const auto& q = body_.attitude;
    const auto& v = body_.velocity;
    const auto& i = body_.body.inertia;
    const Vector3 w = rotate(conjugate(q), body_.spin);
    const Vector3 h = rotate(q, {i.e1 * w.e1, i.e2 * w.e2, i.e3 * w.e3});
    const auto& tip = body_.body.tips[0];
    const double height = (tip.radius - rotate(q, tip.centre).e1) / depth_;
    return {height,        turn_ * q.w,   turn_ * q.x,      turn_ * q.y,      turn_ * q.z,     v.e1 / speed_,
            v.e2 / speed_, v.e3 / speed_, h.e1 / momentum_, h.e2 / momentum_, h.e3 / momentum_};
  }

  void operator()(const State& y, State& dy, double) const {
    const auto q = attitude(y);
    const Vector3 v = velocity(y), w = spin(y);
    Vector3 force{-body_.body.mass * body_.gravity, 0, 0}, moment;
    for (std::size_t i = 0; i < tips(); ++i) {
      const Vector3 d = rotate(q, body_.body.tips[i].centre);
      const double gap = depth_ * y[0] + d.e1 - body_.body.tips[i].radius;
      if (gap >= 0) continue;
      const double bent = body_.lever == model::Lever::radius ? 0 : -gap;
      const Vector3 lever = d - (body_.body.tips[i].radius - bent) * normal_axis;
      const Vector3 push = contact_force(i, -gap, (v + cross(w, d)).e1, tangential(v + cross(w, lever)));
      force = force + push;
      moment = moment + cross(lever, push);
    }
    const auto turning = quaternion_rate(q, w);
    const double a = 1 / body_.body.mass / speed_;
    dy = {v.e1 / depth_,         turn_ * turning.w,     turn_ * turning.x,    turn_ * turning.y,
          turn_ * turning.z,     a * force.e1,          a * force.e2,         a * force.e3,
          moment.e1 / momentum_, moment.e2 / momentum_, moment.e3 / momentum_};
  }

  /// Near the plane a share of the natural time, and far from it of that to reach it at four times the speed.
  double longest_step(const State& y) const {
    const auto q = attitude(y);
    double nearest = infinity;
    for (std::size_t i = 0; i < tips(); ++i) {
      const auto& tip = body_.body.tips[i];
      nearest = std::min(nearest, y[0] + (rotate(q, tip.centre).e1 - tip.radius) / depth_);
    }
    return depth_ / speed_ * (effort_.share + std::max(0.0, nearest) / 4);
  }

  Vector3 velocity(const State& y) const { return speed_ * Vector3{y[5], y[6], y[7]}; }
  /// R I⁻¹ Rᵀ H.
  Vector3 spin(const State& y) const {
    const auto q = attitude(y);
    const auto& i = body_.body.inertia;
    const Vector3 h = rotate(conjugate(q), momentum_ * Vector3{y[8], y[9], y[10]});
    return rotate(q, {h.e1 / i.e1, h.e2 / i.e2, h.e3 / i.e3});
  }

 private:
  /// With one impact the other tip is left out.
  std::size_t tips() const { return body_.impacts == 1 ? 1 : body_.body.tips.size(); }
  Quaternion attitude(const State& y) const { return normalized({y[1], y[2], y[3], y[4]}); }
  /// √δ [k δ (1 − C_H ṅ) − b (1 + C_A ṅ)], and μ |F_n| against the slip.
  Vector3 contact_force(std::size_t i, double depth, double rate, const Vector3& slip) const {
    const auto& law = body_.law[i];
    const double normal = std::sqrt(depth) * (law.stiffness * depth * (1 - law.damping_hertz * rate) -
                                              law.adhesion * (1 + law.damping_adhesion * rate));
    const double size = std::hypot(norm(slip), effort_.smoothing * speed_);
    return normal * normal_axis + (-body_.friction.coefficient * std::abs(normal) / size) * slip;
  }

  const model::Microbody& body_;
  double speed_, reach_, depth_, inertia_, turn_, momentum_;
  Effort effort_;
};

}  // namespace mariotte::test
