// Bodies at one instant: how they move, the forces that act on them, and the accelerations that come of
// these.
#pragma once
#include <vector>

#include "mariotte/model/bodies/bodies_motion.hpp"
#include "mariotte/model/bodies/bodies_setting.hpp"

namespace mariotte::model {

/// Forces are pushed onto bodies that have been moved to a state, and then these are accelerated.
template <class T, int D, class N = double>
class BodiesLoads {
 public:
  using Vector = Vec<T, D>;
  using Contact = SettingContact<D, N>;

  explicit BodiesLoads(const BodiesSetting<D, N>& setting) : setting_(setting) {}

  /// To the state x, free of forces.
  void move(const BodiesLayout<D>& layout, std::span<const T> x) {
    body_.resize(setting_.body.size());
    load_.resize(setting_.body.size());
    clock_ = x[layout.clock()];
    for (Index i = 0; i < layout.bodies; ++i) {
      body_[i] = motion_of(setting_.body[i], layout, x, i);
      load_[i] = {};
      load_[i].momentum = vec_at<turns(D)>(x, layout.momentum(i));
    }
  }

  const std::vector<BodyMotion<T, D>>& body() const { return body_; }
  const Vector& velocity_rate(Index i) const { return load_[i].velocity_rate; }
  const Turn<T, D>& spin_rate(Index i) const { return load_[i].spin_rate; }
  const Turn<T, D>& moment(Index i) const { return load_[i].moment; }

  /// Any contact, closed or not.
  ContactMotion<T, D> motion(Index contact) const {
    const auto& c = setting_.contact[contact];
    return contact_motion(setting_, c, body_a(c), body_[setting_.sphere[c.b].body], clock_);
  }
  GapMotion<T, D> approach(Index contact) const {
    const auto& c = setting_.contact[contact];
    const auto& b = body_[setting_.sphere[c.b].body];
    return gap_motion(c, ContactSides<T, D>(setting_, c, body_a(c), b, clock_));
  }

  /// A force on b of a contact, and its opposite on a.
  void push(Index contact, const ContactMotion<T, D>& c, const Vector& force) {
    const auto& one = setting_.contact[contact];
    auto& b = load_[setting_.sphere[one.b].body];
    b.force = b.force + force;
    b.moment = b.moment + model::moment(c.lever_b, force);
    if (one.plane >= 0) return;
    auto& a = load_[setting_.sphere[one.a].body];
    a.force = a.force - force;
    a.moment = a.moment - model::moment(c.lever_a, force);
  }
  /// Accelerations from the forces pushed so far.
  void accelerate() {
    for (Index i = 0; i < std::ssize(load_); ++i) {
      const auto& body = setting_.body[i];
      load_[i].velocity_rate = lift<T>(setting_.gravity) + T(1 / body.mass) * load_[i].force;
      load_[i].spin_rate = eased(body, body_[i], load_[i].moment - gyroscopic(i));
    }
  }

  /// Tangential part of the acceleration of b on a at the contact, in the turning plane.
  Vector slip_acceleration(Index contact, const ContactMotion<T, D>& c) const {
    const auto& one = setting_.contact[contact];
    const auto side = [&](Index body, const Vector& lever, const Vector& point) {
      return load_[body].velocity_rate + turned(load_[body].spin_rate, lever) +
             turned(body_[body].spin, point);
    };
    Vector u = side(setting_.sphere[one.b].body, c.lever_b, c.point_b) - c.gap_rate * c.normal_rate;
    if (one.plane < 0) u = u - side(setting_.sphere[one.a].body, c.lever_a, c.point_a);
    return u - dot(u, c.normal) * c.normal;
  }

  T gap_acceleration(Index contact, const ContactMotion<T, D>& c) const {
    const auto& one = setting_.contact[contact];
    const auto side = [&](Index sphere) {
      const Index i = setting_.sphere[sphere].body;
      const auto arm = sphere_motion(setting_.sphere[sphere], body_[i]).arm;
      return load_[i].velocity_rate + turned(load_[i].spin_rate, arm) +
             turned(body_[i].spin, turned(body_[i].spin, arm));
    };
    Vector relative = side(one.b);
    T distance = T(0.0);
    if (one.plane < 0) {
      relative = relative - side(one.a);
      distance = c.gap + one.touching_distance();
    }
    return dot(c.normal, relative) + distance * dot(c.normal_rate, c.normal_rate);
  }

 private:
  /// What acts on a body, and what comes of it.
  struct Load {
    Vector force;
    Turn<T, D> moment, momentum;
    Vector velocity_rate;
    Turn<T, D> spin_rate;
  };

  /// Nothing of a plane.
  const BodyMotion<T, D>* body_a(const Contact& c) const {
    return c.plane < 0 ? &body_[setting_.sphere[c.a].body] : nullptr;
  }

  Turn<T, D> gyroscopic(Index i) const {
    if constexpr (D == 2)
      return {};
    else
      return turned(body_[i].spin, load_[i].momentum);
  }

  const BodiesSetting<D, N>& setting_;
  T clock_{};
  std::vector<BodyMotion<T, D>> body_;
  std::vector<Load> load_;
};

}  // namespace mariotte::model
