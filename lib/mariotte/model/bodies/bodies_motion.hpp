// Where bodies and contacts are and how they move: kinematics of a state, over any number.
#pragma once
#include <span>

#include "mariotte/core/state_vectors.hpp"
#include "mariotte/model/bodies/bodies_setting.hpp"
#include "mariotte/series/dual.hpp"
#include "mariotte/series/tape.hpp"

namespace mariotte::model {

/// A value with so many slopes as are carried side by side.
inline constexpr Index slope_lanes = 8;
using Sloped = series::Dual<double, slope_lanes>;

/// One body at one instant.
template <class T, int D>
struct BodyMotion {
  Vec<T, D> shift, velocity;
  Turn<T, D> spin;
  BasicQuaternion<T> turn;  ///< since the start; in the plane w = cos φ − 1 and z = sin φ
};

/// (R − 1) r without cancellation.
template <class T, class N>
Vec<T, 2> swung(const BodyMotion<T, 2>& body, const Vec<N, 2>& r) {
  return {{body.turn.w * r[0] - body.turn.z * r[1], body.turn.z * r[0] + body.turn.w * r[1]}};
}
template <class T, class N>
Vec<T, 3> swung(const BodyMotion<T, 3>& body, const Vec<N, 3>& r) {
  const Vec<T, 3> axis{{body.turn.x, body.turn.y, body.turn.z}}, arm = lift<T>(r);
  return T(2.0) * (body.turn.w * turned(axis, arm) + turned(axis, turned(axis, arm)));
}

/// Unit quaternion of the body in space at one instant.
template <class T, class N>
BasicQuaternion<T> attitude(const SettingBody<3, N>& body, const BasicQuaternion<T>& turn) {
  const auto& q = body.attitude;
  return turn * BasicQuaternion<T>{q.w, q.x, q.y, q.z};
}

/// J⁻¹ M in axes of space.
template <class T, class N>
Vec<T, 1> eased(const SettingBody<2, N>& body, const BodyMotion<T, 2>&, const Vec<T, 1>& moment) {
  return {{(1 / body.inertia[0]) * moment[0]}};
}
template <class T, class N>
Vec<T, 3> eased(const SettingBody<3, N>& body, const BodyMotion<T, 3>& motion, const Vec<T, 3>& moment) {
  if (body.is_round) return T(1 / body.inertia[0]) * moment;
  const auto q = attitude(body, motion.turn);
  const auto m = rotate(conjugate(q), BasicVector3<T>{moment[0], moment[1], moment[2]});
  const auto turned = rotate(q, BasicVector3<T>{(1 / body.inertia[0]) * m.e1, (1 / body.inertia[1]) * m.e2,
                                                (1 / body.inertia[2]) * m.e3});
  return {{turned.e1, turned.e2, turned.e3}};
}

template <class T, class N>
BodyMotion<T, 2> motion_of(const SettingBody<2, N>& body, const BodiesLayout<2>& at, std::span<const T> x,
                           Index i) {
  using std::sin;
  BodyMotion<T, 2> motion{.shift = vec_at<2>(x, at.shift(i)),
                          .velocity = vec_at<2>(x, at.velocity(i)),
                          .spin = vec_at<1>(x, at.momentum(i)),
                          .turn = {.w = T(0.0), .x = T(0.0), .y = T(0.0), .z = T(0.0)}};
  if (!body.has_arms) return motion;
  const T half = sin(0.5 * x[at.turn(i)]);
  motion.turn.w = -2.0 * (half * half);
  motion.turn.z = sin(x[at.turn(i)]);
  return motion;
}
template <class T, class N>
BodyMotion<T, 3> motion_of(const SettingBody<3, N>& body, const BodiesLayout<3>& at, std::span<const T> x,
                           Index i) {
  BodyMotion<T, 3> motion{.shift = vec_at<3>(x, at.shift(i)),
                          .velocity = vec_at<3>(x, at.velocity(i)),
                          .spin = {},
                          .turn = quaternion_at<T>(x, at.turn(i))};
  motion.spin = eased(body, motion, vec_at<3>(x, at.momentum(i)));
  return motion;
}

/// How the two sides of a contact come together; the normal points from a to b.
template <class T, int D>
struct GapMotion {
  Vec<T, D> normal;
  T gap, gap_rate;
  T distance;  ///< of the centres; 0 of a plane
};

/// One contact at one instant.
template <class T, int D>
struct ContactMotion : GapMotion<T, D> {
  Vec<T, D> normal_rate;
  T indentation;               ///< −gap, but never quite 0
  Vec<T, D> lever_a, lever_b;  ///< from the mass centres to the contact point
  Vec<T, D> slip;              ///< tangential velocity of b on a there
  Vec<T, D> point_a, point_b;  ///< velocity of the contact point itself less that of the mass centres
};

/// Sets the indentation, and returns that by which levers are shorter.
template <class T, int D, class N>
T set_indentation(const BodiesSetting<D, N>& setting, const SettingContact<D, N>&, ContactMotion<T, D>& c) {
  const bool touches = -c.gap > setting.smallest_indentation;
  c.indentation = touches ? T(-c.gap) : T(setting.smallest_indentation);
  return touches ? c.indentation : T(0.0);
}
/// Whether a contact has just closed.
template <int D>
bool begins(const BodiesSetting<D>& setting, const SettingContact<D>& contact, double gap, double gap_rate) {
  return std::abs(gap) <= setting.onset_noise * contact.length && gap_rate < 0;
}
/// On a tape an indentation goes through zero as it is, and begins at zero to the last bit.
template <int D>
series::Traced set_indentation(const BodiesSetting<D>& setting, const SettingContact<D>& contact,
                               ContactMotion<series::Traced, D>& c) {
  const bool closes = begins(setting, contact, c.gap.value(), c.gap_rate.value());
  return c.indentation = closes ? at_onset(-c.gap) : -c.gap;
}

/// The sphere of a contact at one instant.
template <class T, int D>
struct SphereMotion {
  Vec<T, D> shift, arm, velocity;
};
template <class T, int D, class N>
SphereMotion<T, D> sphere_motion(const SettingSphere<D, N>& sphere, const BodyMotion<T, D>& body) {
  const auto swing = swung(body, sphere.arm);
  const Vec<T, D> arm = lift<T>(sphere.arm) + swing;
  return {body.shift + swing, arm, body.velocity + turned(body.spin, arm)};
}

/// The sides of a contact. `clock` is the time since the start; `a` is not looked at if it is a plane.
template <class T, int D>
struct ContactSides {
  SphereMotion<T, D> a, b;

  template <class N>
  ContactSides(const BodiesSetting<D, N>& setting, const SettingContact<D, N>& contact,
               const BodyMotion<T, D>* body_a, const BodyMotion<T, D>& body_b, const T& clock)
      : b(sphere_motion(setting.sphere[contact.b], body_b)) {
    if (body_a) {
      a = sphere_motion(setting.sphere[contact.a], *body_a);
    } else {
      a.velocity = lift<T>(setting.plane_velocity[contact.plane]);
      a.shift = clock * a.velocity;
    }
  }
};

template <class T, int D, class N>
GapMotion<T, D> gap_motion(const SettingContact<D, N>& contact, const ContactSides<T, D>& side) {
  GapMotion<T, D> c;
  const Vec<T, D> moved = side.b.shift - side.a.shift, relative = side.b.velocity - side.a.velocity;
  const Vec<T, D> start = lift<T>(contact.apart);
  if (contact.plane < 0) {
    const Vec<T, D> apart = start + moved;
    c.distance = norm(apart);
    c.normal = (1.0 / c.distance) * apart;
    c.gap = contact.gap + dot(start + apart, moved) / (c.distance + contact.distance);
  } else {
    c.distance = T(0.0);
    c.normal = start;
    c.gap = contact.gap + dot(start, moved);
  }
  c.gap_rate = dot(c.normal, relative);
  return c;
}

template <class T, int D, class N>
ContactMotion<T, D> contact_motion(const BodiesSetting<D, N>& setting, const SettingContact<D, N>& contact,
                                   const BodyMotion<T, D>* a, const BodyMotion<T, D>& b, const T& clock) {
  const ContactSides<T, D> side(setting, contact, a, b, clock);
  ContactMotion<T, D> c;
  static_cast<GapMotion<T, D>&>(c) = gap_motion(contact, side);
  const Vec<T, D> relative = side.b.velocity - side.a.velocity;
  c.normal_rate = a ? (1.0 / c.distance) * (relative - c.gap_rate * c.normal) : lift<T>(Vec<double, D>{});
  const T depth = set_indentation(setting, contact, c);
  const T inside = setting.sphere[contact.b].radius - contact.share * depth;
  c.lever_b = side.b.arm - inside * c.normal;
  const Vec<T, D> point = side.b.velocity - inside * c.normal_rate - T(contact.share * c.gap_rate) * c.normal;
  c.point_b = point - b.velocity;
  Vec<T, D> velocity = b.velocity + turned(b.spin, c.lever_b);
  if (a) {
    c.lever_a = side.a.arm + (setting.sphere[contact.a].radius - (1 - contact.share) * depth) * c.normal;
    c.point_a = point - a->velocity;
    velocity = velocity - a->velocity - turned(a->spin, c.lever_a);
  } else {
    velocity = velocity - side.a.velocity;
  }
  c.slip = velocity - dot(velocity, c.normal) * c.normal;
  return c;
}

/// visit(a, b, clock) with the bodies of a contact in a state.
template <int D, class Visit>
auto with_bodies(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, const SettingContact<D>& contact,
                 ConstState x, Visit&& visit) {
  const auto motion = [&](Index sphere) {
    const Index i = setting.sphere[sphere].body;
    return motion_of(setting.body[i], at, x, i);
  };
  const BodyMotion<double, D> b = motion(contact.b), *none = nullptr;
  if (contact.plane >= 0) return visit(none, b, x[at.clock()]);
  const BodyMotion<double, D> a = motion(contact.a);
  return visit(&a, b, x[at.clock()]);
}

template <int D>
ContactMotion<double, D> contact_motion(const BodiesSetting<D>& setting, const BodiesLayout<D>& at,
                                        const SettingContact<D>& contact, ConstState x) {
  return with_bodies(setting, at, contact, x, [&](const auto* a, const auto& b, double clock) {
    return contact_motion(setting, contact, a, b, clock);
  });
}
template <int D>
GapMotion<double, D> gap_motion(const BodiesSetting<D>& setting, const BodiesLayout<D>& at,
                                const SettingContact<D>& contact, ConstState x) {
  return with_bodies(setting, at, contact, x, [&](const auto* a, const auto& b, double clock) {
    return gap_motion(contact, ContactSides<double, D>(setting, contact, a, b, clock));
  });
}

/// Share of its natural indentation that a contact has lost to rounding on its way.
template <int D>
double lost_share(const BodiesSetting<D>& setting, const BodiesLayout<D>& at,
                  const SettingContact<D>& contact, ConstState x) {
  return with_bodies(setting, at, contact, x, [&](const auto* a, const auto& b, double clock) {
    const ContactSides<double, D> side(setting, contact, a, b, clock);
    const auto normal = gap_motion(contact, side).normal;
    double way = 0;
    for (int k = 0; k < D; ++k)
      way += std::abs(normal[k]) * (std::abs(side.a.shift[k]) + std::abs(side.b.shift[k]));
    return lost_digits * way / contact.length;
  });
}

}  // namespace mariotte::model
