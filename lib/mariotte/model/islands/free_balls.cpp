#include "mariotte/model/islands/free_balls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "mariotte/flow/ballistic.hpp"

namespace mariotte::model {

using contact::ContactMode;

FreeBalls::FreeBalls(const DimensionlessChain& chain, const ChainLayout& layout, ConstState start)
    : chain_(chain), layout_(layout), x_(start.begin(), start.end()), mode_(layout.contacts()) {
  contact_time_.resize(layout.contacts());
  const auto pulls = [](double gravity) { return gravity != 0; };
  if (std::any_of(chain.gravity.begin(), chain.gravity.end(), pulls)) ball_time_.resize(layout.velocities());
}

double FreeBalls::velocity(Index i, Instant t) const {
  const double v = x_[layout_.velocity[i]];
  return ball_time_.empty() ? v : v - chain_.gravity[i] * (t - ball_time_[i]);
}

double FreeBalls::gap(Index j, Instant t) const {
  const double elapsed = t - contact_time_[j];
  return gap(j) - elapsed * (approach(j, contact_time_[j]) + 0.5 * elapsed * drive(j));
}

double FreeBalls::approach(Index j, Instant t) const {
  return velocity(j, t) - velocity(j + 1, t);
}

void FreeBalls::move_ball(Index i, Instant t) {
  if (ball_time_.empty()) return;
  x_[layout_.velocity[i]] = velocity(i, t);
  ball_time_[i] = t;
}

void FreeBalls::move_contact(Index j, Instant t) {
  auto& gap = x_[layout_.gap[j]];
  gap = this->gap(j, t);
  contact_time_[j] = t;
  auto& mode = mode_[j];
  if (mode == ContactMode::slack && gap >= 0) mode = ContactMode::open;
  const bool idles = mode == ContactMode::open || mode == ContactMode::hovering;
  const double now = approach(j, t);
  const double closing = clearance(j) - gap;
  if (!idles || !(gap + closing < 0) || now < 0 || now > chain_.noise_speed) return;
  mode = ContactMode::hovering;
  gap = std::max(gap, -closing - chain_.noise_depth[j]);
}

Instant FreeBalls::meeting(Index j, Instant t) const {
  const double speed = approach(j, t), height = gap(j) + level(j);
  const bool leads_nowhere =
      mode_[j] == ContactMode::slack || (drive(j) == 0 && !(speed > chain_.noise_speed));
  if (leads_nowhere) return {infinity};
  if (height <= 0 && speed > 0) return t;
  return t + flow::first_crossing(flow::Crossing::falling, height, -speed, -drive(j));
}

bool FreeBalls::is_due(Index j, Instant t, double accuracy) const {
  const auto mode = mode_[j];
  if (mode != ContactMode::open && mode != ContactMode::hovering) return false;
  const double speed = approach(j, t), window = 0.1 * accuracy * chain_.time[j];
  const bool counts = speed > (mode == ContactMode::hovering && drive(j) == 0 ? chain_.noise_speed : 0);
  return counts && gap(j) + level(j) <= window * speed;
}

bool FreeBalls::rests(Index j, Instant t) const {
  return mode_[j] == ContactMode::open && clearance(j) == 0 && approach(j, t) == 0;
}

State FreeBalls::slice(Index first, Index last) {
  const auto from = layout_.velocity[first], to = layout_.velocity[last] + 1;
  return State(x_).subspan(from, to - from);
}

void FreeBalls::stamp(Index first, Index last, Instant t) {
  std::fill(contact_time_.begin() + first, contact_time_.begin() + last, t);
  if (!ball_time_.empty()) std::fill(ball_time_.begin() + first, ball_time_.begin() + last + 1, t);
}

void FreeBalls::repeat(const Repetition& of, Instant t) {
  const bool forward = of.shift > 0;
  const Index rear = forward ? of.first - of.shift : of.last;
  for (Index j = rear; j < rear + std::abs(of.shift); ++j) move_contact(j, t);
  const double rest = x_[layout_.velocity[forward ? of.last + 1 : of.first - 1]];
  const auto later = [&](Instant time, Index periods) {
    return time + static_cast<double>(periods) * of.period;
  };
  const auto same = [](double value, Index) { return value; };
  model::repeat(mode_, of);
  model::repeat(contact_time_, of.first, of.last, of.shift, of.count, later);
  model::repeat(x_, layout_.velocity[of.first], layout_.velocity[of.last] + 1, 2 * of.shift, of.count, same);
  const Index first = forward ? of.first : of.last + of.way() + 1;
  for (Index i = first; i < first + std::abs(of.way()); ++i) x_[layout_.velocity[i]] = rest;
}

std::vector<double> FreeBalls::take(Instant t) {
  for (Index j = 0; j < contacts(); ++j) move_contact(j, t);
  for (Index i = 0; i < layout_.velocities(); ++i) move_ball(i, t);
  return std::move(x_);
}

}  // namespace mariotte::model
