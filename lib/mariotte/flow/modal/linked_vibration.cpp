#include "mariotte/flow/modal/linked_vibration.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow {

bool LinkedVibration::find(const LinkedPhase& phase) {
  phase_ = &phase;
  begin(phase.contact);
  find_islands();
  shapes_.resize(std::max(shapes_.size(), islands_.size()));
  for (auto& island : islands_) {
    island.first_mode = std::ssize(modes_);
    gather(island);
    island.ratio = common_ratio();
    if (island.ratio < 0) return false;
    flow::find(shapes_of(island), phase, members(island));
    add_natural_modes(island, shapes_of(island));
  }
  return true;
}

void LinkedVibration::find_islands() {
  const auto& contact = phase_->contact;
  std::vector<bool> found(contact.size());
  const auto take = [&](Index j) {
    found[j] = true;
    members_.push_back(j);
  };
  const auto moves = [&](Index i, Index j) { return dot(phase_->direction[i], phase_->push[j]) != 0; };
  for (Index first = 0; first < std::ssize(contact); ++first) {
    if (!contact[first].pushes() || found[first]) continue;
    auto& island = islands_.emplace_back(Island{std::ssize(members_), 0, 0, 0, 0});
    take(first);
    for (Index k = island.first; k < std::ssize(members_); ++k)
      for (Index j = first + 1; j < std::ssize(contact); ++j)
        if (contact[j].pushes() && !found[j] && moves(members_[k], j)) take(j);
    island.count = std::ssize(members_) - island.first;
    std::sort(members_.begin() + island.first, members_.end());
  }
}

void LinkedVibration::start_island(const Island& island) {
  take_straight_parts(island);
  ride_natural_modes(island, shapes_of(island));
}

/// In terms of z = √K δ, a shape that moves nothing goes on at the rate at which it starts: none but rounding
/// noise unless walls drive it.
void LinkedVibration::take_straight_parts(const Island& island) {
  const auto& shapes = shapes_of(island);
  for (Index i = island.modes(); i < island.count; ++i) {
    double value = 0, rate = 0, size = 0;
    for (Index j = 0; j < island.count; ++j) {
      const double shape = std::sqrt(stiffness_[j]) * shapes.at(j, i);
      value += shape * depth_[j];
      rate += shape * rate_[j];
      size += std::abs(shape * rate_[j]);
    }
    if (std::abs(rate) <= 64 * epsilon * size) rate = 0;
    for (Index j = 0; j < island.count; ++j) {
      const double root = std::sqrt(stiffness_[j]), shape = shapes.at(j, i);
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
