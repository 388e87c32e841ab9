#include "mariotte/model/bodies/bodies_cluster.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/mindlin.hpp"
#include "mariotte/model/bodies/bodies_flight.hpp"
#include "mariotte/model/bodies/bodies_stick.hpp"
#include "mariotte/model/bodies/near_pairs.hpp"

namespace mariotte::model {

using Field = flow::ClusterField;

BodiesCluster::BodiesCluster(const BodiesSetting<2>& setting) : setting_(setting) {
  are_balls_ = std::all_of(setting.sphere.begin(), setting.sphere.end(),
                           [](const auto& sphere) { return norm(sphere.arm) == 0; });
}

namespace {

/// Closed contacts are sorted.
bool is_closed(const BodiesMode& mode, Index contact) {
  const auto place = std::lower_bound(mode.closed.begin(), mode.closed.end(), contact,
                                      [](const ClosedContact& one, Index i) { return one.contact < i; });
  return place != mode.closed.end() && place->contact == contact;
}

}  // namespace

/// Powers of 1 and 3/2 without damper, and friction that is known where contacts are.
bool BodiesCluster::admits(const BodiesMode& mode) const {
  const auto is_known = [&](const ClosedContact& one) {
    const auto& c = setting_.contact[one.contact];
    const auto* power = contact::power_law(c.law);
    if (one.slack || !power || power->damping != 0) return false;
    if (c.tangential.law == TangentialLaw::rigid && one.friction == Friction::stick) return false;
    if (power->exponent == 1) return c.tangential.law != TangentialLaw::mindlin;
    return power->exponent == 1.5;
  };
  return are_balls_ && !mode.closed.empty() && std::all_of(mode.closed.begin(), mode.closed.end(), is_known);
}

void BodiesCluster::bind(const BodiesMode& mode, const BodiesLayout<2>& layout,
                         std::span<const double> magnitude, const BodiesGuards& guards) {
  mode_ = &mode;
  layout_ = layout;
  magnitude_ = magnitude;
  guards_ = guards;
}

void BodiesCluster::gather(ConstState x, bool all) {
  cluster_ = {
      .ball = {}, .link = {}, .gap = {}, .pull_x = setting_.gravity[0], .pull_y = setting_.gravity[1]};
  open_.clear();
  body_.clear();
  far_.clear();
  ball_.assign(layout_.bodies, -1);
  for (const auto& one : mode_->closed) add_closed(one);
  const bool near = watches_near(setting_, *mode_);
  const Index count = near ? std::ssize(mode_->near) : std::ssize(setting_.contact);
  for (Index k = 0; k < count; ++k) {
    const Index contact = near ? mode_->near[k] : k;
    if (is_closed(*mode_, contact)) continue;
    const bool waits = !all && is_far(setting_, layout_, x, setting_.contact[contact]);
    waits ? far_.push_back(contact) : add_open(contact, k);
  }
}

const flow::Cluster& BodiesCluster::load(ConstState x, bool may_close) {
  for (std::size_t i = 0; i < body_.size(); ++i) {
    auto& ball = cluster_.ball[i];
    const auto velocity = vec_at<2>(x, layout_.velocity(body_[i]));
    ball.velocity_x = velocity[0];
    ball.velocity_y = velocity[1];
    ball.spin = x[layout_.momentum(body_[i])];
  }
  for (std::size_t j = 0; j < cluster_.link.size(); ++j)
    load_link(mode_->closed[j], x, may_close, cluster_.link[j]);
  for (std::size_t j = 0; j < open_.size(); ++j) load_gap(open_[j], x, cluster_.gap[j]);
  return cluster_;
}

bool BodiesCluster::stays_far(ConstState x, double time, ConstState reach) {
  reach_.clear();
  for (Index i = 0; i < layout_.bodies; ++i)
    reach_.push_back(ball_[i] >= 0 ? reach[ball_[i]]
                                   : flown(setting_, vec_at<2>(x, layout_.velocity(i)), time));
  for (Index i = 0; i < layout_.bodies && watches_near(setting_, *mode_); ++i)
    if (!(gone(x, i) + reach_[i] < 0.5 * setting_.skin)) return false;
  return std::all_of(far_.begin(), far_.end(), [&](Index contact) {
    return stays_open(setting_, layout_, x, setting_.contact[contact], time, std::span<const double>(reach_));
  });
}

/// From where it was when near contacts were listed.
double BodiesCluster::gone(ConstState x, Index body) const {
  return norm(vec_at<2>(x, layout_.shift(body)) - vec_at<2>(ConstState(mode_->from), 2 * body));
}

/// Half as far as it may go.
Index BodiesCluster::stray(ConstState x) const {
  for (Index i = 0; i < layout_.bodies && watches_near(setting_, *mode_); ++i)
    if (gone(x, i) > 0.25 * setting_.skin) return guards_.strays + i;
  return -1;
}

void BodiesCluster::move(ConstState from, const flow::ClusterMotion& motion, State x) const {
  std::copy(from.begin(), from.end(), x.begin());
  for (Index i = 0; i < layout_.bodies; ++i)
    if (ball_[i] < 0)
      model::fly(setting_, layout_, from, i, motion.time, x);
    else
      move_ball(i, motion.ball[ball_[i]], x);
  x[layout_.clock()] += motion.time;
  for (std::size_t j = 0; j < mode_->closed.size(); ++j)
    move_slot(mode_->closed[j], cluster_.link[j], motion.link[j], x);
}

void BodiesCluster::move_ball(Index body, const flow::BallMove& ball, State x) const {
  const Index shift = layout_.shift(body), velocity = layout_.velocity(body);
  x[shift] += ball.shift_x;
  x[shift + 1] += ball.shift_y;
  x[layout_.turn(body)] += ball.turn;
  x[velocity] = ball.velocity_x;
  x[velocity + 1] = ball.velocity_y;
  x[layout_.momentum(body)] = ball.spin;
}

void BodiesCluster::move_slot(const ClosedContact& closed, const flow::ClusterLink& link,
                              const flow::LinkMotion& motion, State x) const {
  x[layout_.spring(closed.slot)] = motion.spring;
  x[layout_.normal(closed.slot)] += motion.normal;
  x[layout_.tangential(closed.slot)] += motion.tangential;
  double* loss = &x[layout_.losses(closed.slot)];
  if (!link.sticks) loss[0] += motion.work;
  if (setting_.contact[closed.contact].tangential.law == TangentialLaw::mindlin)
    loss[1] += rescaled(closed, link, motion);
}

/// Of the work against a Mindlin spring that sticks what it does not store.
double BodiesCluster::rescaled(const ClosedContact& closed, const flow::ClusterLink& link,
                               const flow::LinkMotion& motion) const {
  const auto& friction = setting_.contact[closed.contact].tangential;
  const double root = std::sqrt(std::max(motion.depth, 0.0)), from = std::sqrt(link.start[Field::depth]);
  if (!link.sticks)
    return mindlin_rescaled(friction.friction * link.parameter[Field::stiffness], friction.stiffness, from,
                            root, closed.unloading);
  const auto stored = [&](double width, double spring) {
    if (closed.unloading) return 0.5 * friction.stiffness * width * spring * spring;
    return width > 0 ? 0.5 * spring * spring / (friction.stiffness * width) : 0;
  };
  return motion.work - (stored(root, motion.spring) - stored(from, link.start[Field::spring]));
}

}  // namespace mariotte::model
