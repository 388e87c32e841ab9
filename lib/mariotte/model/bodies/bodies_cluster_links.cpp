// What series are told of the contacts of a cluster.
#include <algorithm>
#include <cmath>

#include "mariotte/model/bodies/bodies_cluster.hpp"
#include "mariotte/model/bodies/law_numbers.hpp"

namespace mariotte::model {

using Field = flow::ClusterField;

namespace {

Index slot_guard(Index slot, SlotGuard guard) {
  return slot * guards_per_slot + static_cast<Index>(guard);
}

flow::ClusterBall moving(const Vec<double, 2>& velocity) {
  return {.velocity_x = velocity[0], .velocity_y = velocity[1]};
}

}  // namespace

int BodiesCluster::ball_of(Index sphere) {
  const Index body = setting_.sphere[sphere].body;
  if (ball_[body] >= 0) return ball_[body];
  const auto& one = setting_.body[body];
  cluster_.ball.push_back({.ease = 1 / one.mass,
                           .turn_ease = 1 / one.inertia[0],
                           .velocity_weight = 1 / magnitude_[layout_.velocity(body)],
                           .spin_weight = 1 / magnitude_[layout_.momentum(body)]});
  body_.push_back(body);
  return ball_[body] = static_cast<int>(std::ssize(body_)) - 1;
}

void BodiesCluster::add_open(Index contact, Index place) {
  const auto& c = setting_.contact[contact];
  flow::ClusterGap gap{.b = ball_of(c.b), .close = guards_.gaps + place};
  if (c.plane < 0) gap.a = ball_of(c.a);
  const auto at = std::find(mode_->touching.begin(), mode_->touching.end(), contact);
  if (at != mode_->touching.end()) {
    gap.part = guards_.partings + (at - mode_->touching.begin());
    gap.touch_depth = setting_.gap_noise * c.length;
  }
  open_.push_back(contact);
  cluster_.gap.push_back(gap);
}

void BodiesCluster::add_closed(const ClosedContact& closed) {
  const auto& c = setting_.contact[closed.contact];
  const auto& power = *contact::power_law(c.law);
  flow::ClusterLink link;
  link.has_root = power.exponent == 1.5;
  link.parameter[Field::stiffness] = power.stiffness;
  link.open = slot_guard(closed.slot, SlotGuard::open);
  link.turn = slot_guard(closed.slot, SlotGuard::turn);
  link.unloading = closed.unloading;
  link.rate_noise = setting_.slip_noise * setting_.speed;
  set_sides(c, link);
  set_weights(closed, link);
  if (closed.friction != Friction::none) set_friction(closed, link);
  cluster_.link.push_back(link);
}

void BodiesCluster::set_sides(const SettingContact<2>& c, flow::ClusterLink& link) {
  link.b = ball_of(c.b);
  link.radius_b = setting_.sphere[c.b].radius;
  link.share_b = c.share;
  if (c.plane >= 0) return;
  link.a = ball_of(c.a);
  link.radius_a = setting_.sphere[c.a].radius;
  link.share_a = 1 - c.share;
  link.parameter[Field::radii] = c.touching_distance();
  link.parameter[Field::turning] = 1;
}

void BodiesCluster::set_friction(const ClosedContact& closed, flow::ClusterLink& link) const {
  link.friction = slot_guard(closed.slot, SlotGuard::friction);
  link.sticks = closed.friction == Friction::stick;
  link.sign = closed.sign;
  link.cap = setting_.contact[closed.contact].tangential.friction;
  link.cap_noise = setting_.slip_noise;
  link.force_noise = setting_.slip_noise * setting_.contact[closed.contact].force;
  link.sticks ? set_stick(closed, link) : set_slip(closed, link);
}

/// S is the force T of a Mindlin spring that is loaded, else the stretch ξ.
void BodiesCluster::set_stick(const ClosedContact& closed, flow::ClusterLink& link) const {
  const auto& friction = setting_.contact[closed.contact].tangential;
  auto& p = link.parameter;
  if (friction.law != TangentialLaw::mindlin) {
    p[Field::hold] = friction.stiffness;
    p[Field::stretch] = 1;
  } else if (closed.unloading) {
    p[Field::hold_root] = friction.stiffness;
    p[Field::stretch] = 1;
  } else {
    p[Field::hold] = 1;
    p[Field::stretch_root] = friction.stiffness;
  }
}

/// The rate at which a spring gives way is u − μ s (df_n/dt)/k_t, that of Mindlin's on unloading 2/3 of that.
void BodiesCluster::set_slip(const ClosedContact& closed, flow::ClusterLink& link) const {
  const auto& friction = setting_.contact[closed.contact].tangential;
  auto& p = link.parameter;
  p[Field::directed] = closed.sign * friction.friction * p[Field::stiffness];
  if (!friction.has_spring()) return;
  const double growth = p[Field::directed] / friction.stiffness;
  if (friction.law == TangentialLaw::mindlin)
    p[Field::growth] = (closed.unloading ? 1 : 1.5) * growth;
  else
    p[link.has_root ? Field::growth_root : Field::growth] = (link.has_root ? 1.5 : 1) * growth;
}

void BodiesCluster::set_weights(const ClosedContact& closed, flow::ClusterLink& link) const {
  const Index slot = closed.slot;
  link.weight[Field::spring] = 1 / magnitude_[layout_.spring(slot)];
  link.weight[Field::depth] = 1 / setting_.contact[closed.contact].length;
  link.weight[Field::force] = 1 / setting_.contact[closed.contact].force;
  link.weight[Field::normal] = 1 / magnitude_[layout_.normal(slot)];
  link.weight[Field::tangential] = 1 / magnitude_[layout_.tangential(slot)];
  link.weight[Field::work] = 1 / magnitude_[layout_.losses(slot)];
}

void BodiesCluster::load_link(const ClosedContact& closed, ConstState x, bool may_close,
                              flow::ClusterLink& link) const {
  const auto& one = setting_.contact[closed.contact];
  const auto c = gap_motion(setting_, layout_, one, x);
  const auto& b = cluster_.ball[link.b];
  const auto a = link.a < 0 ? moving(setting_.plane_velocity[one.plane]) : cluster_.ball[link.a];
  link.begins = may_close && begins(setting_, one, c.gap, c.gap_rate);
  auto& start = link.start;
  start[Field::normal_x] = c.normal[0];
  start[Field::normal_y] = c.normal[1];
  start[Field::depth] = link.begins ? 0 : -c.gap;
  start[Field::velocity_x] = b.velocity_x - a.velocity_x;
  start[Field::velocity_y] = b.velocity_y - a.velocity_y;
  start[Field::spins] = link.radius_a * a.spin + link.radius_b * b.spin;
  start[Field::shared] = link.share_a * a.spin + link.share_b * b.spin;
  start[Field::spring] = link.begins && link.sticks ? 0 : x[layout_.spring(closed.slot)];
}

void BodiesCluster::load_gap(Index contact, ConstState x, flow::ClusterGap& gap) const {
  const auto& one = setting_.contact[contact];
  const auto c = gap_motion(setting_, layout_, one, x);
  gap.gap = c.gap + closing_depth(one.law, memory_of(*mode_, contact));
  gap.normal_x = c.normal[0];
  gap.normal_y = c.normal[1];
  if (gap.a >= 0) {
    gap.bend = 0.5 / (c.gap + one.touching_distance());
  } else {
    gap.velocity_x = setting_.plane_velocity[one.plane][0];
    gap.velocity_y = setting_.plane_velocity[one.plane][1];
  }
}

}  // namespace mariotte::model
