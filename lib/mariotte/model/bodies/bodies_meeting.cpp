// Bodies in flight meet, and no meeting is missed.
#include <algorithm>
#include <cmath>

#include "mariotte/model/bodies/bodies_approach.hpp"
#include "mariotte/model/bodies/bodies_phase.hpp"

namespace mariotte::model {
namespace {

/// Looks at one gap in a window of time before it is given up: never reached by bodies that do meet.
constexpr int most_looks = 100'000;

/// Until then a gap does not close that has this slope and bends no more than this towards closing.
double open_for(double gap, double slope, double bend) {
  const double root = std::sqrt(slope * slope + 2 * bend * gap);
  return slope > 0 ? (slope + root) / bend : 2 * gap / (root - slope);
}

}  // namespace

template <int D>
Approach<D> BodiesPhase<D>::approach(ConstState x, Index contact) const {
  const auto& c = setting_.contact[contact];
  Approach<D> both{.setting = setting_, .contact = c};
  const bool is_plane = both.is_plane();
  const auto motion = [&](const SettingSphere<D>& sphere) {
    return motion_of(setting_.body[sphere.body], layout_, x, sphere.body);
  };
  both.b = motion(both.sphere_b());
  if (!is_plane) both.a = motion(both.sphere_a());
  both.now = gap_motion(
      c, ContactSides<double, D>(setting_, c, is_plane ? nullptr : &both.a, both.b, x[layout_.clock()]));
  both.relative = both.b.velocity - (is_plane ? setting_.plane_velocity[c.plane] : both.a.velocity);
  both.arm_b = norm(both.sphere_b().arm);
  both.arm_a = is_plane ? 0 : norm(both.sphere_a().arm);
  both.fall = is_plane ? dot(both.now.normal, setting_.gravity) : 0;
  both.dent = closing_depth(contact);
  both.radii = (is_plane ? both.sphere_b().radius : c.touching_distance()) - both.dent;
  return both;
}

/// What touches is open until it comes together faster than noise.
template <int D>
double BodiesPhase<D>::open_gap(const Approach<D>& both, Index contact) const {
  const double gap = both.now.gap, rate = both.now.gap_rate;
  const auto& touching = mode_->touching;
  if (std::find(touching.begin(), touching.end(), contact) == touching.end())
    return std::max(gap + both.dent, 0.0);
  if (rate > -setting_.slip_noise * setting_.speed) return infinity;
  return std::max(gap + setting_.gap_noise * both.contact.length, 0.0);
}

template <int D>
double BodiesPhase<D>::meeting(ConstState x, Index contact, double limit) const {
  const auto both = approach(x, contact);
  const double gap = open_gap(both, contact);
  if (gap == infinity) return infinity;
  if (both.swings_a() || both.swings_b()) return swinging_meeting(x, both, contact, gap, limit);
  return both.straight_meeting(gap);
}

/// Of what swings: the gap lies above the parabola of its value, slope and largest bend.
template <int D>
double BodiesPhase<D>::swinging_meeting(ConstState x, const Approach<D>& both, Index contact, double gap,
                                        double limit) const {
  const auto times = both.near_until(limit);
  if (times.are_none()) return infinity;
  const double bend = both.bend();
  std::vector<double> flown(x.size());
  double t = times.first;
  bool left = t > 0 || gap > 0;
  for (int k = 0; k < most_looks && t <= times.last; ++k) {
    fly(x, t, flown);
    const auto there = approach(flown, contact);
    const double h = std::max(there.now.gap + both.dent, 0.0), slope = there.now.gap_rate;
    const double ahead = open_for(h, slope, bend), least = 4 * epsilon * std::max(t, setting_.time);
    if (slope <= 0 && left && ahead <= least) return t;
    if (slope <= 0 && !left) return 0;
    left = true;
    t += std::max(ahead, least);
  }
  return infinity;
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
    const auto times = both.near();
    if (!both.is_still() && !times.are_none() && times.last >= 0) return false;
  }
  return true;
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

template double BodiesPhase<2>::escape_gap(Index) const;
template double BodiesPhase<3>::escape_gap(Index) const;
template bool BodiesPhase<2>::flies_apart(ConstState) const;
template bool BodiesPhase<3>::flies_apart(ConstState) const;
template bool BodiesPhase<2>::comes_together(ConstState) const;
template bool BodiesPhase<3>::comes_together(ConstState) const;
template double BodiesPhase<2>::first_meeting(ConstState, double, double, std::vector<Index>&) const;
template double BodiesPhase<3>::first_meeting(ConstState, double, double, std::vector<Index>&) const;

}  // namespace mariotte::model
