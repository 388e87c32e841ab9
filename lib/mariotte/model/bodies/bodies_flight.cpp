// Free flight of bodies: closed forms, and meetings that cannot be missed.
#include "mariotte/model/bodies/bodies_flight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mariotte/flow/ballistic.hpp"
#include "mariotte/flow/flight.hpp"
#include "mariotte/model/bodies/bodies_phase.hpp"

namespace mariotte::model {
namespace {

/// Looks at one gap in a window of time before it is given up: never reached by bodies that do meet.
constexpr int most_looks = 100'000;

/// The turn since the start after time t.
void turn(const BodiesLayout<2>& at, const SettingBody<2>&, ConstState x, Index i, double t, State result) {
  result[at.turn(i)] = x[at.turn(i)] + t * x[at.momentum(i)];
}
void turn(const BodiesLayout<3>& at, const SettingBody<3>& body, ConstState x, Index i, double t,
          State result) {
  const Vector3 momentum = vector_at(x, at.momentum(i));
  const Quaternion q = quaternion_at(x, at.turn(i));
  if (norm(momentum) == 0) return;
  if (body.is_round) {
    const double rate = norm(momentum) / body.inertia[0];
    put<double>(result, at.turn(i), rotation((1 / norm(momentum)) * momentum, rate * t) * q);
    return;
  }
  const flow::SymmetricBody symmetric{.mass = body.mass,
                                      .axial = body.inertia[0],
                                      .transverse = body.inertia[1],
                                      .arm = {},
                                      .radius = {},
                                      .gravity = 0};
  const auto flown = flow::flown(q * body.attitude, momentum, symmetric, t);
  put<double>(result, at.turn(i), flown * conjugate(body.attitude));
}

/// Times in which two points with this relative motion are closer than `reach`.
struct Window {
  double first = 0, last = infinity;
};
template <int D>
Window near(const Vec<double, D>& apart, const Vec<double, D>& velocity, double reach) {
  const double a = dot(velocity, velocity), b = dot(apart, velocity), c = dot(apart, apart) - reach * reach;
  if (a == 0) return c > 0 ? Window{infinity, infinity} : Window{};
  const double square = b * b - a * c;
  if (square < 0) return {infinity, infinity};
  const double root = std::sqrt(square);
  return {std::max(0.0, (-b - root) / a), (-b + root) / a};
}

}  // namespace

template <int D>
void fly(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x, Index i, double t,
         State result) {
  for (int k = 0; k < D; ++k) {
    const double g = setting.gravity[k], v = x[at.velocity(i) + k];
    result[at.shift(i) + k] = x[at.shift(i) + k] + t * (v + 0.5 * t * g);
    result[at.velocity(i) + k] = v + t * g;
  }
  turn(at, setting.body[i], x, i, t, result);
}

template <int D>
void BodiesPhase<D>::fly(ConstState x, double t, State result) const {
  std::copy(x.begin(), x.end(), result.begin());
  for (Index i = 0; i < layout_.bodies; ++i) model::fly(setting_, layout_, x, i, t, result);
  result[layout_.clock()] += t;
}

/// Largest acceleration of a sphere's centre by the turning of its body.
template <int D>
double BodiesPhase<D>::gap_bend(const BodyMotion<double, D>& body, Index i,
                                const SettingSphere<D>& sphere) const {
  const double spin = norm(body.spin), arm = norm(sphere.arm);
  double nutation = 0;
  if constexpr (D == 3)
    if (const auto& one = setting_.body[i]; !one.is_round) {
      const auto& j = one.inertia;
      nutation = spin * spin * std::max(j[0], j[1]) / std::min(j[0], j[1]);
    }
  return (spin * spin + nutation) * arm;
}

/// Times in which a point whose height is this parabola is no higher than `reach`, if it may be.
Window near_plane(double height, double rate, double fall, double reach) {
  const double lowest = rate < 0 && fall > 0 ? height - rate * rate / (2 * fall) : height;
  if ((rate >= 0 || fall > 0) && fall >= 0 && lowest > reach) return {infinity, infinity};
  Window window;
  if (fall == 0 && rate < 0 && height > reach) window.first = (height - reach) / -rate;
  if (fall == 0 && rate > 0) window.last = (reach - height) / rate;
  return window;
}

/// How both sides of a contact move.
template <int D>
struct BodiesPhase<D>::Approach {
  const SettingContact<D>& contact;
  const SettingSphere<D>& sphere;  ///< b
  BodyMotion<double, D> a = {}, b = {};
  GapMotion<double, D> now = {};
  Vec<double, D> relative = {};  ///< velocity of the mass centres, or of that of b and the plane
  double arm_a = 0, arm_b = 0;
  double fall = 0;   ///< acceleration of a gap to a plane
  double dent = 0;   ///< depth at which the contact closes
  double radii = 0;  ///< without it

  bool is_plane() const { return contact.plane >= 0; }
  /// The gap never changes.
  bool is_still() const {
    return fall == 0 && norm(relative) + arm_a * norm(a.spin) + arm_b * norm(b.spin) == 0;
  }
  /// When spheres about the mass centres touch that hold both bodies.
  Window near(const BodiesSetting<D>& setting) const {
    const auto on_b = sphere_motion(sphere, b);
    if (is_plane())
      return near_plane(now.gap + dent - dot(now.normal, on_b.arm), dot(now.normal, relative), fall, arm_b);
    const auto on_a = sphere_motion(setting.sphere[contact.a], a);
    const Vec<double, D> spheres = (now.gap + dent + radii) * now.normal;
    return model::near<D>(spheres - on_b.arm + on_a.arm, relative, radii + arm_a + arm_b);
  }
};

template <int D>
typename BodiesPhase<D>::Approach BodiesPhase<D>::approach(ConstState x, Index contact) const {
  const auto& c = setting_.contact[contact];
  const auto& sphere_b = setting_.sphere[c.b];
  const bool is_plane = c.plane >= 0;
  Approach all{.contact = c, .sphere = sphere_b};
  all.b = motion_of(setting_.body[sphere_b.body], layout_, x, sphere_b.body);
  if (!is_plane) {
    const Index body = setting_.sphere[c.a].body;
    all.a = motion_of(setting_.body[body], layout_, x, body);
  }
  all.now = gap_motion(
      c, ContactSides<double, D>(setting_, c, is_plane ? nullptr : &all.a, all.b, x[layout_.clock()]));
  all.relative = all.b.velocity - (is_plane ? setting_.plane_velocity[c.plane] : all.a.velocity);
  all.arm_b = norm(sphere_b.arm);
  all.arm_a = is_plane ? 0 : norm(setting_.sphere[c.a].arm);
  all.fall = is_plane ? dot(all.now.normal, setting_.gravity) : 0;
  all.dent = closing_depth(contact);
  all.radii = (is_plane ? sphere_b.radius : c.touching_distance()) - all.dent;
  return all;
}

template <int D>
double BodiesPhase<D>::escape_gap(Index contact) const {
  constexpr double clearly = 2.1;  // twice is enough
  const auto& c = setting_.contact[contact];
  const double arm_a = c.plane >= 0 ? 0 : norm(setting_.sphere[c.a].arm);
  return clearly * (arm_a + norm(setting_.sphere[c.b].arm)) + std::max(0.0, -closing_depth(contact));
}

template <int D>
bool BodiesPhase<D>::flies_apart(ConstState x) const {
  if (escapes_ == 0 || !at_peace_) return false;
  for (Index c = 0; c < std::ssize(setting_.contact); ++c) {
    const auto both = approach(x, c);
    const auto window = both.near(setting_);
    if (!both.is_still() && window.first < infinity && window.last >= 0) return false;
  }
  return true;
}

template <int D>
double BodiesPhase<D>::meeting(ConstState x, Index contact, double limit) const {
  const auto all = approach(x, contact);
  const auto& [c, sphere_b, of_a, b, now, relative, arm_a, arm_b, fall, dent, radii] = all;
  const bool is_plane = all.is_plane();
  const Index body_b = sphere_b.body, body_a = is_plane ? -1 : setting_.sphere[c.a].body;
  auto a = of_a;
  const bool turns_a = !is_plane && arm_a > 0 && norm(a.spin) > 0, turns_b = arm_b > 0 && norm(b.spin) > 0;
  double gap = std::max(now.gap + dent, 0.0);
  if (std::find(mode_->touching.begin(), mode_->touching.end(), contact) != mode_->touching.end()) {
    if (now.gap_rate > -setting_.slip_noise * setting_.speed) return infinity;
    gap = std::max(now.gap + setting_.gap_noise * c.length, 0.0);
  }
  if (is_plane && !turns_b) return flow::first_crossing(flow::Crossing::falling, gap, now.gap_rate, fall);

  if (!turns_a && !turns_b) {
    const double distance = radii + gap, slope = distance * now.gap_rate, ends = gap * (distance + radii);
    const double speed = dot(relative, relative), square = slope * slope - speed * ends;
    return slope < 0 && square >= 0 ? ends / (std::sqrt(square) - slope) : infinity;
  }

  // Where something turns: the gap lies above the parabola of its value, slope and largest bend.
  auto window = all.near(setting_);
  if (window.first == infinity) return infinity;
  double bend = gap_bend(b, body_b, sphere_b);
  if (is_plane) {
    bend += std::abs(fall);
  } else {
    const double across = norm(relative) + norm(a.spin) * arm_a + norm(b.spin) * arm_b;
    bend += gap_bend(a, body_a, setting_.sphere[c.a]) + across * across / radii;
  }
  const double full = 2 * std::numbers::pi / std::max({norm(a.spin), norm(b.spin)});
  if (norm(relative) == 0 && fall == 0)
    window.last = std::min(window.last, (turns_a && turns_b ? 1000 : 1.001) * full);
  window.last = std::min(window.last, limit);
  std::vector<double> flown(x.size());
  const double least = 4 * epsilon;
  double t = window.first;
  bool left = t > 0 || gap > 0;
  for (int k = 0; k < most_looks && t <= window.last; ++k) {
    fly(x, t, flown);
    const auto there_b = motion_of(setting_.body[body_b], layout_, ConstState(flown), body_b);
    if (!is_plane) a = motion_of(setting_.body[body_a], layout_, ConstState(flown), body_a);
    const ContactSides<double, D> sides(setting_, c, is_plane ? nullptr : &a, there_b,
                                        flown[layout_.clock()]);
    const auto there = gap_motion(c, sides);
    const double h = std::max(there.gap + dent, 0.0), slope = there.gap_rate;
    const double root = std::sqrt(slope * slope + 2 * bend * h);
    const double ahead = slope > 0 ? (slope + root) / bend : 2 * h / (root - slope);
    if (slope <= 0 && left && ahead <= least * std::max(t, setting_.time)) return t;
    if (slope <= 0 && !left) return 0;
    left = true;
    t += std::max(ahead, least * std::max(t, setting_.time));
  }
  return infinity;
}

/// Whether what moves a contact is slower than a tenth of the accuracy, as what rounding leaves of equal
/// velocities, and nothing else brings it together.
template <int D>
bool BodiesPhase<D>::drifts(ConstState x, Index contact) const {
  const auto& c = setting_.contact[contact];
  const bool is_plane = c.plane >= 0;
  const auto velocity = [&](Index sphere) {
    return motion_of(setting_.body[setting_.sphere[sphere].body], layout_, x, setting_.sphere[sphere].body)
        .velocity;
  };
  const auto has_arm = [&](Index sphere) { return norm(setting_.sphere[sphere].arm) > 0; };
  if (contact::adheres(c.law) || has_arm(c.b) || (!is_plane && has_arm(c.a))) return false;
  if (is_plane && dot(c.apart, setting_.gravity) != 0) return false;
  const Vec<double, D> relative =
      velocity(c.b) - (is_plane ? setting_.plane_velocity[c.plane] : velocity(c.a));
  const double speed = is_plane ? std::abs(dot(c.apart, relative)) : norm(relative);
  return speed <= std::max(setting_.slip_noise, setting_.onset_noise) * setting_.speed;
}

template <int D>
bool BodiesPhase<D>::comes_together(ConstState x) const {
  for (Index c = 0; c < std::ssize(setting_.contact); ++c)
    if (meeting(x, c, infinity) < infinity && !drifts(x, c)) return true;
  return false;
}

template <int D>
double BodiesPhase<D>::first_meeting(ConstState x, double limit, double window,
                                     std::vector<Index>& fired) const {
  double first = infinity;
  meetings_.clear();
  for (Index c = 0; c < std::ssize(setting_.contact); ++c) {
    const double time = meeting(x, c, std::min(limit, first + window));
    if (!(time < infinity)) continue;
    meetings_.push_back({time, c});
    first = std::min(first, time);
  }
  for (const auto& [time, contact] : meetings_)
    if (time <= first + window) fired.push_back(gap_guard(contact));
  return first;
}

template void fly(const BodiesSetting<2>&, const BodiesLayout<2>&, ConstState, Index, double, State);
template void fly(const BodiesSetting<3>&, const BodiesLayout<3>&, ConstState, Index, double, State);
template void BodiesPhase<2>::fly(ConstState, double, State) const;
template void BodiesPhase<3>::fly(ConstState, double, State) const;
template double BodiesPhase<2>::escape_gap(Index) const;
template double BodiesPhase<3>::escape_gap(Index) const;
template bool BodiesPhase<2>::flies_apart(ConstState) const;
template bool BodiesPhase<3>::flies_apart(ConstState) const;
template bool BodiesPhase<2>::comes_together(ConstState) const;
template bool BodiesPhase<3>::comes_together(ConstState) const;
template double BodiesPhase<2>::first_meeting(ConstState, double, double, std::vector<Index>&) const;
template double BodiesPhase<3>::first_meeting(ConstState, double, double, std::vector<Index>&) const;

}  // namespace mariotte::model
