#include "mariotte/model/bodies/bodies_rest.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::model {
namespace {

constexpr double rounding = 1e-12;  // of the speed

/// Of what a state or its rates say of a body. In space the spin is no more than about the axis of least
/// inertia; in the plane the state has it.
template <int D>
double speed_of(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, Index body, ConstState x) {
  const auto& one = setting.body[body];
  double spin = 0;
  for (int k = 0; k < turns(D); ++k)
    for (int j = 0; j < turns(D); ++j)
      spin = std::max(spin, std::abs(x[at.momentum(body) + k]) / (D == 2 ? 1 : one.inertia[j]));
  return std::max(norm(vec_at<D>(x, at.velocity(body))), one.reach * spin);
}

/// Of bodies that touch.
template <int D>
double largest_speed(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, const BodiesMode& mode,
                     ConstState x) {
  double largest = 0;
  for (const auto& closed : mode.closed) {
    const auto& contact = setting.contact[closed.contact];
    largest = std::max(largest, speed_of(setting, at, setting.sphere[contact.b].body, x));
    if (contact.plane < 0)
      largest = std::max(largest, speed_of(setting, at, setting.sphere[contact.a].body, x));
  }
  return largest;
}

/// Balls that roll on each other and on planes may go on as they do; others touch elsewhere then.
template <int D>
bool rolls(const BodiesSetting<D>& setting, const BodiesMode& mode, const BodiesField<double, D>& field) {
  for (std::size_t i = 0; i < mode.closed.size(); ++i) {
    const auto& contact = setting.contact[mode.closed[i].contact];
    const auto has_arms = [&](Index sphere) { return setting.body[setting.sphere[sphere].body].has_arms; };
    if (has_arms(contact.b) || (contact.plane < 0 && has_arms(contact.a))) return false;
    const auto& motion = field.contact(i).motion;
    if (std::max(std::abs(motion.gap_rate), norm(motion.slip)) > rounding * setting.speed) return false;
  }
  return true;
}

}  // namespace

template <int D>
bool is_held(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, const BodiesMode& mode, ConstState x,
             BodiesField<double, D>& field) {
  if (setting.has_limit || mode.closed.empty() || norm(setting.gravity) > 0) return false;
  for (const auto& velocity : setting.plane_velocity)
    if (norm(velocity) > 0) return false;
  const auto& first = setting.contact[mode.closed.front().contact];  // most often it says no
  if (std::abs(gap_motion(setting, at, first, x).gap_rate) > rounding * setting.speed) return false;
  field.evaluate(at, mode, x);
  if (largest_speed(setting, at, mode, x) > rounding * setting.speed && !rolls(setting, mode, field))
    return false;
  std::vector<double> rates(x.size());
  field.rates(mode, x, rates);
  return setting.time * largest_speed(setting, at, mode, rates) < rounding * setting.speed;
}

template bool is_held(const BodiesSetting<2>&, const BodiesLayout<2>&, const BodiesMode&, ConstState,
                      BodiesField<double, 2>&);
template bool is_held(const BodiesSetting<3>&, const BodiesLayout<3>&, const BodiesMode&, ConstState,
                      BodiesField<double, 3>&);

}  // namespace mariotte::model
