#include "mariotte/flow/modal/row_vibration.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow {
namespace {

/// Largest condition of a root. Two roots that nearly meet are each wrong by it, and their amplitudes by its
/// square: 10⁻¹² at most.
constexpr double worst_condition = 100;

}  // namespace

bool RowVibration::find(const SerialPhase& phase) {
  phase_ = &phase;
  begin(phase.contact);
  find_groups();
  natural_.resize(std::max(natural_.size(), groups_.size()));
  damped_.resize(std::max(damped_.size(), groups_.size()));
  for (auto& group : groups_) {
    group.first_mode = std::ssize(modes_);
    gather_row(group);
    group.ratio = common_ratio();
    if (group.ratio < 0) {
      if (!add_damped_modes(group)) return false;
      continue;
    }
    auto& shapes = natural_[&group - groups_.data()];
    flow::find(shapes, inverse_mass_, stiffness_);
    if (group.straight == 1) *std::min_element(shapes.frequency.begin(), shapes.frequency.end()) = 0;
    add_natural_modes(group, shapes);
  }
  return true;
}

void RowVibration::find_groups() {
  const auto& contact = phase_->contact;
  const auto is_wall = [&](Index body) { return phase_->body[body].inverse_mass == 0; };
  for (Index j = 0; j < std::ssize(contact); ++j) {
    if (!contact[j].pushes()) continue;
    if (members_.empty() || members_.back() != j - 1 || is_wall(j))
      groups_.push_back({std::ssize(members_), 0, 0, 0, 0});
    members_.push_back(j);
    ++groups_.back().count;
  }
  for (auto& group : groups_) {
    const auto row = members(group);
    group.straight = is_wall(row.front()) && is_wall(row.back() + 1) ? 1 : 0;
  }
}

void RowVibration::gather_row(const VibrationGroup& group) {
  gather(group);
  const Index first = members(group).front();
  inverse_mass_.clear();
  for (Index i = first; i <= first + group.count; ++i) inverse_mass_.push_back(phase_->body[i].inverse_mass);
}

bool RowVibration::add_damped_modes(const VibrationGroup& group) {
  auto& shapes = damped_[&group - groups_.data()];
  if (!flow::find(shapes, row()) || !(shapes.condition < worst_condition)) return false;
  for (std::size_t i = 0; i < shapes.root.size(); ++i) {
    const auto value = shapes.root[i].value();
    const double decay = std::max(0.0, -value.real());
    if (value.imag() > 0)
      modes_.push_back({NaturalMode::Form::oscillating, decay, value.imag()});
    else
      modes_.push_back({NaturalMode::Form::separate, decay, -shapes.root[++i].value().real()});
  }
  return true;
}

void RowVibration::start_group(const VibrationGroup& group) {
  gather_row(group);
  if (group.straight == 1) take_straight_part(group);
  const Index place = &group - groups_.data();
  if (group.ratio >= 0)
    ride_natural_modes(group, natural_[place]);
  else
    ride_damped_modes(group, damped_[place]);
}

/// Walls that come closer at a steady speed press all contacts between them with one force F₀ + F₁ t.
void RowVibration::take_straight_part(const VibrationGroup& group) {
  double compliance = 0, delay = 0, depth = 0, rate = 0;
  for (Index j = 0; j < group.count; ++j) {
    compliance += 1 / stiffness_[j];
    delay += damping_[j] / stiffness_[j] / stiffness_[j];
    depth += depth_[j];
    rate += rate_[j];
  }
  const double slope = rate / compliance, constant = (depth + slope * delay) / compliance;
  for (Index j = 0; j < group.count; ++j) {
    auto& motion = motion_[members_[group.first + j]];
    motion.force.constant = constant;
    motion.force.slope = slope;
    motion.depth.slope = slope / stiffness_[j];
    motion.depth.constant = (constant - damping_[j] * motion.depth.slope) / stiffness_[j];
    depth_[j] -= motion.depth.constant;
    rate_[j] -= motion.depth.slope;
  }
}

/// The real part of 2 a e^{λt} off the axis, a e^{λt} on it.
void RowVibration::ride_damped_modes(const VibrationGroup& group, const DampedModes& shapes) {
  const auto damped_row = row();
  const auto amplitude = [&](Index root) { return shapes.amplitude(damped_row, root, depth_, rate_); };
  const Index count = group.count;
  Index place = group.first_mode;
  for (Index i = 0; i < std::ssize(shapes.root); ++i, ++place) {
    const auto first = amplitude(i);
    const double turn = shapes.root[i].value().imag();
    const auto second = turn > 0 ? 0.0 : amplitude(i + 1);
    const auto weight = [&](const std::vector<std::complex<double>>& shape, Index j) -> Weight {
      const auto z = first * shape[count * i + j];
      if (turn > 0) return {2 * z.real(), -2 * turn * z.imag()};
      return {z.real(), (second * shape[count * (i + 1) + j]).real()};
    };
    for (Index j = 0; j < count; ++j) {
      auto& motion = motion_[members_[group.first + j]];
      motion.depth.weight[place] = weight(shapes.depth, j);
      motion.force.weight[place] = weight(shapes.force, j);
    }
    if (!(turn > 0)) ++i;
  }
}

double RowVibration::approach(Index j, ConstState x) const {
  return x[phase_->body[j].velocity] - x[phase_->body[j + 1].velocity];
}

void RowVibration::add_impulse(Index j, double impulse, State x) const {
  const auto &left = phase_->body[j], &right = phase_->body[j + 1];
  x[left.velocity] -= impulse * left.inverse_mass;
  x[right.velocity] += impulse * right.inverse_mass;
}

/// From the other sides of its two bodies.
void RowVibration::add_pushes(Index j) {
  const auto& contact = phase_->contact;
  if (j > 0 && contact[j - 1].pushes()) add_push(j, j - 1, phase_->body[j].inverse_mass);
  if (j + 1 < std::ssize(contact) && contact[j + 1].pushes())
    add_push(j, j + 1, phase_->body[j + 1].inverse_mass);
}

}  // namespace mariotte::flow
