// How both sides of a contact come together in flight.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mariotte/flow/ballistic.hpp"
#include "mariotte/model/bodies/bodies_motion.hpp"
#include "mariotte/model/bodies/bodies_setting.hpp"

namespace mariotte::model {

/// Times in which two bodies may be near each other.
struct NearTimes {
  double first = 0, last = infinity;
  bool are_none() const { return first == infinity; }
};
inline constexpr NearTimes never_near{infinity, infinity};

/// In which two points with this relative motion are closer than `reach`.
template <int D>
NearTimes near_point(const Vec<double, D>& apart, const Vec<double, D>& velocity, double reach) {
  const double a = dot(velocity, velocity), b = dot(apart, velocity), c = dot(apart, apart) - reach * reach;
  if (a == 0) return c > 0 ? never_near : NearTimes{};
  const double square = b * b - a * c;
  if (square < 0) return never_near;
  const double root = std::sqrt(square);
  return {std::max(0.0, (-b - root) / a), (-b + root) / a};
}

/// In which a point whose height is this parabola is no higher than `reach`, if it may be.
inline NearTimes near_plane(double height, double rate, double fall, double reach) {
  const double lowest = rate < 0 && fall > 0 ? height - rate * rate / (2 * fall) : height;
  if ((rate >= 0 || fall > 0) && fall >= 0 && lowest > reach) return never_near;
  NearTimes times;
  if (fall == 0 && rate < 0 && height > reach) times.first = (height - reach) / -rate;
  if (fall == 0 && rate > 0) times.last = (reach - height) / rate;
  return times;
}

/// What nutation adds to the square of the spin.
inline double nutation(const SettingBody<2>&, double) {
  return 0;
}
inline double nutation(const SettingBody<3>& body, double spin) {
  const auto& j = body.inertia;
  return body.is_round ? 0 : spin * spin * std::max(j[0], j[1]) / std::min(j[0], j[1]);
}

/// Both sides of a contact at one instant.
template <int D>
struct Approach {
  const BodiesSetting<D>& setting;
  const SettingContact<D>& contact;
  BodyMotion<double, D> a = {}, b = {};  ///< a rests if it is a plane
  GapMotion<double, D> now = {};
  Vec<double, D> relative = {};  ///< velocity of the mass centres, or of that of b and the plane
  double arm_a = 0, arm_b = 0;
  double fall = 0;   ///< acceleration of a gap to a plane
  double dent = 0;   ///< depth at which the contact closes
  double radii = 0;  ///< without it

  bool is_plane() const { return contact.plane >= 0; }
  const SettingSphere<D>& sphere_b() const { return setting.sphere[contact.b]; }
  const SettingSphere<D>& sphere_a() const { return setting.sphere[contact.a]; }

  /// Spheres off the mass centre swing about it.
  bool swings_a() const { return arm_a > 0 && norm(a.spin) > 0; }
  bool swings_b() const { return arm_b > 0 && norm(b.spin) > 0; }
  /// The gap never changes.
  bool is_still() const {
    return fall == 0 && norm(relative) + arm_a * norm(a.spin) + arm_b * norm(b.spin) == 0;
  }

  /// When spheres about the mass centres touch that hold both bodies.
  NearTimes near() const {
    const auto on_b = sphere_motion(sphere_b(), b);
    if (is_plane())
      return near_plane(now.gap + dent - dot(now.normal, on_b.arm), dot(now.normal, relative), fall, arm_b);
    const auto on_a = sphere_motion(sphere_a(), a);
    const Vec<double, D> spheres = (now.gap + dent + radii) * now.normal;
    return near_point<D>(spheres - on_b.arm + on_a.arm, relative, radii + arm_a + arm_b);
  }
  /// The same until `limit`. Bodies that only turn have shown all of it after a turn.
  NearTimes near_until(double limit) const {
    auto times = near();
    const double turn = 2 * std::numbers::pi / std::max(norm(a.spin), norm(b.spin));
    const double turns = swings_a() && swings_b() ? 1000 : 1.001;
    if (norm(relative) == 0 && fall == 0) times.last = std::min(times.last, turns * turn);
    times.last = std::min(times.last, limit);
    return times;
  }

  /// When a gap closes of which nothing swings.
  double straight_meeting(double gap) const {
    if (is_plane()) return flow::first_crossing(flow::Crossing::falling, gap, now.gap_rate, fall);
    const double distance = radii + gap, slope = distance * now.gap_rate, ends = gap * (distance + radii);
    const double speed = dot(relative, relative), square = slope * slope - speed * ends;
    return slope < 0 && square >= 0 ? ends / (std::sqrt(square) - slope) : infinity;
  }

  /// Largest acceleration of the gap towards its closing.
  double bend() const {
    const double of_b = swing(b, setting.body[sphere_b().body], arm_b);
    if (is_plane()) return of_b + std::abs(fall);
    const double across = norm(relative) + norm(a.spin) * arm_a + norm(b.spin) * arm_b;
    return of_b + swing(a, setting.body[sphere_a().body], arm_a) + across * across / radii;
  }

 private:
  /// Largest acceleration of a sphere's centre by the turning of its body.
  static double swing(const BodyMotion<double, D>& motion, const SettingBody<D>& body, double arm) {
    const double spin = norm(motion.spin);
    return (spin * spin + nutation(body, spin)) * arm;
  }
};

}  // namespace mariotte::model
