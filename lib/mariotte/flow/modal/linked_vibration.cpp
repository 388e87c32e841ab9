#include "mariotte/flow/modal/linked_vibration.hpp"

#include <cmath>

namespace mariotte::flow {

bool LinkedVibration::find(const LinkedPhase& phase) {
  phase_ = &phase;
  begin(phase.contact);
  for (Index j = 0; j < std::ssize(phase.contact); ++j)
    if (phase.contact[j].pushes()) members_.push_back(j);
  islands_.push_back({0, std::ssize(members_), 0, 0, 0});
  auto& island = islands_.back();
  gather(island);
  island.ratio = common_ratio();
  if (island.ratio < 0) return false;
  flow::find(shapes_, phase, members_);
  add_natural_modes(island, shapes_);
  return true;
}

void LinkedVibration::start_island(const Island& island) {
  take_straight_parts(island);
  ride_natural_modes(island, shapes_);
}

/// In terms of z = √K δ, a shape that moves nothing goes on at the rate at which it starts: none but rounding
/// noise unless walls drive it.
void LinkedVibration::take_straight_parts(const Island& island) {
  for (Index i = island.modes(); i < island.count; ++i) {
    double value = 0, rate = 0, size = 0;
    for (Index j = 0; j < island.count; ++j) {
      const double shape = std::sqrt(stiffness_[j]) * shapes_.at(j, i);
      value += shape * depth_[j];
      rate += shape * rate_[j];
      size += std::abs(shape * rate_[j]);
    }
    if (std::abs(rate) <= 64 * epsilon * size) rate = 0;
    for (Index j = 0; j < island.count; ++j) {
      const double root = std::sqrt(stiffness_[j]), shape = shapes_.at(j, i);
      auto& motion = motion_[members_[island.first + j]];
      motion.depth.constant += shape / root * value;
      motion.depth.slope += shape / root * rate;
      motion.force.constant += shape * root * (value + island.ratio * rate);
      motion.force.slope += shape * root * rate;
    }
  }
}

double LinkedVibration::approach(Index j, ConstState x) const {
  return -gap_rate(phase_->direction[j], x);
}

void LinkedVibration::push(Index j, double impulse, State x) const {
  for (const auto& [freedom, change] : phase_->push[j]) x[freedom] += change * impulse;
}

void LinkedVibration::add_pushes(Index open) {
  for (const Index closed : members_)
    add_push(open, closed, -dot(phase_->direction[open], phase_->push[closed]));
}

}  // namespace mariotte::flow
