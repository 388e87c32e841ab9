#include "mariotte/flow/modal/linked_vibration.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow {

bool LinkedVibration::find(const LinkedPhase& phase) {
  phase_ = &phase;
  begin(phase.contact);
  find_groups();
  shapes_.resize(std::max(shapes_.size(), groups_.size()));
  for (auto& group : groups_) {
    group.first_mode = std::ssize(modes_);
    gather(group);
    group.ratio = common_ratio();
    if (group.ratio < 0) return false;
    flow::find(shapes_of(group), phase, members(group));
    add_natural_modes(group, shapes_of(group));
  }
  return true;
}

void LinkedVibration::find_groups() {
  const auto& contact = phase_->contact;
  std::vector<bool> found(contact.size());
  const auto take = [&](Index j) {
    found[j] = true;
    members_.push_back(j);
  };
  const auto moves = [&](Index i, Index j) { return dot(phase_->direction[i], phase_->response[j]) != 0; };
  for (Index first = 0; first < std::ssize(contact); ++first) {
    if (!contact[first].pushes() || found[first]) continue;
    auto& group = groups_.emplace_back(VibrationGroup{std::ssize(members_), 0, 0, 0, 0});
    take(first);
    for (Index k = group.first; k < std::ssize(members_); ++k)
      for (Index j = first + 1; j < std::ssize(contact); ++j)
        if (contact[j].pushes() && !found[j] && moves(members_[k], j)) take(j);
    group.count = std::ssize(members_) - group.first;
    std::sort(members_.begin() + group.first, members_.end());
  }
}

void LinkedVibration::start_group(const VibrationGroup& group) {
  take_straight_parts(group);
  ride_natural_modes(group, shapes_of(group));
}

/// In terms of z = √K δ, a shape that moves nothing goes on at the rate at which it starts: none but rounding
/// noise unless walls drive it.
void LinkedVibration::take_straight_parts(const VibrationGroup& group) {
  const auto& shapes = shapes_of(group);
  for (Index i = group.modes(); i < group.count; ++i) {
    double value = 0, rate = 0, size = 0;
    for (Index j = 0; j < group.count; ++j) {
      const double shape = std::sqrt(stiffness_[j]) * shapes.at(j, i);
      value += shape * depth_[j];
      rate += shape * rate_[j];
      size += std::abs(shape * rate_[j]);
    }
    if (std::abs(rate) <= 64 * epsilon * size) rate = 0;
    for (Index j = 0; j < group.count; ++j) {
      const double root = std::sqrt(stiffness_[j]), shape = shapes.at(j, i);
      auto& motion = motion_[members_[group.first + j]];
      motion.depth.constant += shape / root * value;
      motion.depth.slope += shape / root * rate;
      motion.force.constant += shape * root * (value + group.ratio * rate);
      motion.force.slope += shape * root * rate;
    }
  }
}

double LinkedVibration::approach(Index j, ConstState x) const {
  return -gap_rate(phase_->direction[j], x);
}

void LinkedVibration::add_impulse(Index j, double impulse, State x) const {
  for (const auto& [dof, change] : phase_->response[j]) x[dof] += change * impulse;
}

void LinkedVibration::add_pushes(Index open) {
  for (const Index closed : members_)
    add_push(open, closed, -dot(phase_->direction[open], phase_->response[closed]));
}

}  // namespace mariotte::flow
