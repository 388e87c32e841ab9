#include "mariotte/model/bodies/bodies_balls.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/bodies/bodies_flight.hpp"
#include "mariotte/model/bodies/bodies_stick.hpp"
#include "mariotte/model/bodies/near_pairs.hpp"

namespace mariotte::model {

using flow::BallMotion;
using flow::Grip;

namespace {

Grip grip_of(const ClosedContact& mode, TangentialLaw law) {
  if (mode.friction == Friction::none) return Grip::none;
  const bool sticks = mode.friction == Friction::stick;
  if (law == TangentialLaw::rigid) return sticks ? Grip::rigid_stick : Grip::rigid_slip;
  if (sticks) return mode.unloading ? Grip::stick_unloading : Grip::stick_loading;
  return mode.unloading ? Grip::slip_unloading : Grip::slip_loading;
}

bool is_hertz(const contact::Law& law) {
  const auto* power = contact::power_law(law);
  return power && power->exponent == 1.5 && power->damping == 0;
}

}  // namespace

bool BodiesBalls::admits(const BodiesMode& mode) const {
  if (mode.closed.size() != 1 || !mode.touching.empty()) return false;
  const auto& one = mode.closed.front();
  const auto& c = setting_.contact[one.contact];
  const auto is_ball = [&](Index sphere) { return sphere < 0 || norm(setting_.sphere[sphere].arm) == 0; };
  return !one.slack && is_hertz(c.law) && c.tangential.law != TangentialLaw::spring && is_ball(c.a) &&
         is_ball(c.b);
}

void BodiesBalls::bind(const BodiesMode& mode, const BodiesLayout<2>& layout,
                       std::span<const double> magnitude, Index first_guard) {
  mode_ = &mode;
  layout_ = layout;
  const auto& closed = mode.closed.front();
  one_ = &setting_.contact[closed.contact];
  slot_ = closed.slot;
  b_ = setting_.sphere[one_->b].body;
  a_ = one_->plane < 0 ? setting_.sphere[one_->a].body : Index{-1};
  share_b_ = one_->mass / setting_.body[b_].mass;
  share_a_ = a_ < 0 ? 0 : one_->mass / setting_.body[a_].mass;
  set_guards(closed, first_guard);
  set_bodies();
  set_friction(closed.sign);
  set_weights(magnitude);
}

void BodiesBalls::set_guards(const ClosedContact& closed, Index first) {
  contact_ = {.grip = grip_of(closed, one_->tangential.law), .pair = a_ >= 0, .unloading = closed.unloading};
  const auto guard = [&](SlotGuard which) { return first + static_cast<Index>(which); };
  contact_.is_alone = setting_.contact.size() == 1;
  contact_.open = guard(SlotGuard::open);
  contact_.turn = guard(SlotGuard::turn);
  if (contact_.grip != Grip::none) contact_.friction = guard(SlotGuard::friction);
}

void BodiesBalls::set_bodies() {
  const auto& c = *one_;
  auto& p = contact_.parameter;
  p[BallMotion::stiffness] = contact::power_law(c.law)->stiffness;
  p[BallMotion::inverse_mass] = 1 / c.mass;
  p[BallMotion::radius_b] = setting_.sphere[c.b].radius;
  p[BallMotion::share_b] = c.share;
  p[BallMotion::ease_b] = 1 / setting_.body[b_].inertia[0];
  if (a_ < 0) {
    p[BallMotion::pull_normal] = dot(setting_.gravity, c.apart);
    p[BallMotion::pull_along] = dot(setting_.gravity, across(c.apart));
    return;
  }
  p[BallMotion::radius_a] = setting_.sphere[c.a].radius;
  p[BallMotion::radii] = c.touching_distance();
  p[BallMotion::share_a] = 1 - c.share;
  p[BallMotion::ease_a] = 1 / setting_.body[a_].inertia[0];
}

void BodiesBalls::set_friction(double sign) {
  const auto& friction = one_->tangential;
  auto& p = contact_.parameter;
  p[BallMotion::coulomb] = friction.friction;
  p[BallMotion::sign] = sign;
  p[BallMotion::directed] = sign * friction.friction;
  p[BallMotion::grip_stiffness] = friction.stiffness;
  if (friction.has_spring())
    p[BallMotion::growth] = friction.friction * p[BallMotion::stiffness] / friction.stiffness;
  contact_.rate_noise = setting_.slip_noise * setting_.speed;
  contact_.force_share = setting_.slip_noise;
  contact_.force_noise = setting_.slip_noise * one_->force;
  contact_.faint_force = setting_.faint_stick() * one_->force;
}

/// Those of the state, where they are the same; relative motion is that of the body that moves less.
void BodiesBalls::set_weights(std::span<const double> magnitude) {
  auto& m = contact_.weight;
  const Index a = a_ < 0 ? b_ : a_;
  m[BallMotion::root] = std::sqrt(one_->length);
  m[BallMotion::approach] = m[BallMotion::along] =
      std::min(magnitude[layout_.velocity(a)], magnitude[layout_.velocity(b_)]);
  m[BallMotion::spin_a] = magnitude[layout_.momentum(a)];
  m[BallMotion::spin_b] = magnitude[layout_.momentum(b_)];
  m[BallMotion::spring] = magnitude[layout_.spring(slot_)];
  m[BallMotion::time] = one_->time;
  m[BallMotion::run] = one_->length;
  m[BallMotion::turned] = m[BallMotion::turn_a] = magnitude[layout_.turn(a)];
  m[BallMotion::turn_b] = magnitude[layout_.turn(b_)];
  m[BallMotion::normal] = magnitude[layout_.normal(slot_)];
  m[BallMotion::tangential] = magnitude[layout_.tangential(slot_)];
  m[BallMotion::lost] = m[BallMotion::rescaled] = magnitude[layout_.losses(slot_)];
  for (auto& one : m) one = 1 / one;
}

BodiesBalls::Motion BodiesBalls::begin(ConstState x, bool may_close) {
  const auto c = gap_motion(setting_, layout_, *one_, x);
  const auto velocity = vec_at<2>(x, layout_.velocity(b_));
  const auto other = a_ < 0 ? setting_.plane_velocity[one_->plane] : vec_at<2>(x, layout_.velocity(a_));
  normal_ = c.normal;
  common_ = a_ < 0 ? other : share_a_ * velocity + share_b_ * other;
  start_ = {};
  if (!(may_close && begins(setting_, *one_, c.gap, c.gap_rate)))
    start_[BallMotion::root] = std::sqrt(std::max(-c.gap, 0.0));
  start_[BallMotion::approach] = -c.gap_rate;
  start_[BallMotion::along] = dot(velocity - other, across(c.normal));
  start_[BallMotion::spin_a] = a_ < 0 ? 0 : x[layout_.momentum(a_)];
  start_[BallMotion::spin_b] = x[layout_.momentum(b_)];
  start_[BallMotion::spring] = x[layout_.spring(slot_)];
  return start_;
}

void BodiesBalls::move(ConstState from, const Motion& motion, State x) const {
  std::copy(from.begin(), from.end(), x.begin());
  const double time = motion[BallMotion::time], root = motion[BallMotion::root];
  for (Index i = 0; i < layout_.bodies; ++i)
    if (i != a_ && i != b_) model::fly(setting_, layout_, from, i, time, x);
  const double sine = std::sin(motion[BallMotion::turned]), half = std::sin(0.5 * motion[BallMotion::turned]);
  const auto swung = [&](const Vec<double, 2>& r) { return -2 * half * half * r + sine * across(r); };
  const auto normal = normal_ + swung(normal_);
  const auto relative = -motion[BallMotion::approach] * normal + motion[BallMotion::along] * across(normal);
  const double sunk = (root - start_[BallMotion::root]) * (root + start_[BallMotion::root]);
  const double distance = contact_.parameter[BallMotion::radii] - root * root;
  const auto gone =
      -sunk * normal_ + (a_ < 0 ? motion[BallMotion::run] * across(normal_) : distance * swung(normal_));
  move_body(b_, share_b_, gone, relative, motion, x);
  if (a_ >= 0) move_body(a_, -share_a_, gone, relative, motion, x);
  x[layout_.clock()] += time;
  move_slot(motion, x);
}

void BodiesBalls::move_body(Index body, double share, const Vec<double, 2>& gone,
                            const Vec<double, 2>& relative, const Motion& motion, State x) const {
  const double time = motion[BallMotion::time];
  const auto pull = a_ < 0 ? Vec<double, 2>{} : time * setting_.gravity;
  put(x, layout_.shift(body),
      vec_at<2>(ConstState(x), layout_.shift(body)) + time * (common_ + 0.5 * pull) + share * gone);
  put(x, layout_.velocity(body), common_ + pull + share * relative);
  x[layout_.turn(body)] += motion[body == b_ ? BallMotion::turn_b : BallMotion::turn_a];
  x[layout_.momentum(body)] = motion[body == b_ ? BallMotion::spin_b : BallMotion::spin_a];
}

void BodiesBalls::move_slot(const Motion& motion, State x) const {
  x[layout_.spring(slot_)] = motion[BallMotion::spring];
  x[layout_.normal(slot_)] += motion[BallMotion::normal];
  x[layout_.tangential(slot_)] += motion[BallMotion::tangential];
  double* loss = &x[layout_.losses(slot_)];
  loss[0] += motion[BallMotion::lost];
  loss[1] += rescaled(motion);
}

/// What the stiffness of a loaded spring cost is the work against it less what it stores.
double BodiesBalls::rescaled(const Motion& motion) const {
  if (contact_.grip == Grip::stick_loading)
    return motion[BallMotion::rescaled] - (stored(motion) - stored(start_));
  if (contact_.grip != Grip::slip_loading && contact_.grip != Grip::slip_unloading)
    return motion[BallMotion::rescaled];
  const auto& p = contact_.parameter;
  return mindlin_rescaled(p[BallMotion::coulomb] * p[BallMotion::stiffness], p[BallMotion::grip_stiffness],
                          start_[BallMotion::root], motion[BallMotion::root], contact_.unloading);
}

double BodiesBalls::stored(const Motion& motion) const {
  const double root = motion[BallMotion::root], force = motion[BallMotion::spring];
  return root > 0 ? 0.5 * force * force / (one_->tangential.stiffness * root) : 0;
}

/// How far a body goes within a time, at most.
double BodiesBalls::reach(ConstState x, Index body, double time, double speed) const {
  const double share = body == a_ ? share_a_ : body == b_ ? share_b_ : 0;
  const auto velocity = share > 0 ? common_ : vec_at<2>(x, layout_.velocity(body));
  return flown(setting_, velocity, time) + time * share * speed;
}

bool BodiesBalls::is_clear(ConstState x, double time, double speed) const {
  reach_.clear();
  for (Index i = 0; i < layout_.bodies; ++i) reach_.push_back(reach(x, i, time, speed));
  const auto is_far = [&](Index contact) {
    const auto& c = setting_.contact[contact];
    return &c == one_ || stays_open(setting_, layout_, x, c, time, std::span<const double>(reach_));
  };
  if (!watches_near(setting_, *mode_)) {
    for (Index c = 0; c < std::ssize(setting_.contact); ++c)
      if (!is_far(c)) return false;
    return true;
  }
  for (Index i = 0; i < layout_.bodies; ++i) {
    const auto gone = vec_at<2>(x, layout_.shift(i)) - vec_at<2>(ConstState(mode_->from), 2 * i);
    if (!(norm(gone) + reach_[i] < 0.5 * setting_.skin)) return false;
  }
  return std::all_of(mode_->near.begin(), mode_->near.end(), is_far);
}

}  // namespace mariotte::model
