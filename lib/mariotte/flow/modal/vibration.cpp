#include "mariotte/flow/modal/vibration.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow {

double ContactMotion::impulse_at(const std::vector<Swing>& swing, double time) const {
  double sum = time * (force.constant + 0.5 * force.slope * time);
  for (std::size_t i = 0; i < impulse.size(); ++i) sum += dot(impulse[i], swing[i].change);
  return sum;
}

std::span<const Index> Vibration::members(const VibrationGroup& group) const {
  return {&members_[group.first], static_cast<std::size_t>(group.count)};
}

double Vibration::slowest() const {
  double least = infinity;
  for (const auto& mode : modes_) least = std::min(least, mode.slowest());
  return least;
}
double Vibration::fastest() const {
  double largest = 0;
  for (const auto& mode : modes_) largest = std::max(largest, mode.fastest());
  return largest;
}

void Vibration::begin(std::span<const PhaseContact> contacts) {
  contacts_ = contacts;
  modes_.clear();
  groups_.clear();
  members_.clear();
}

void Vibration::gather(const VibrationGroup& group) {
  stiffness_.clear();
  damping_.clear();
  for (const Index j : members(group)) {
    stiffness_.push_back(contacts_[j].stiffness);
    damping_.push_back(contacts_[j].damping);
  }
}

double Vibration::common_ratio() const {
  const double ratio = damping_.front() / stiffness_.front();
  for (std::size_t j = 1; j < stiffness_.size(); ++j)
    if (std::abs(damping_[j] - ratio * stiffness_[j]) > 8 * epsilon * damping_[j]) return -1;
  return ratio;
}

void Vibration::add_natural_modes(VibrationGroup& group, NaturalModes& shapes) {
  group.straight = 0;
  for (Index i = group.count - 1; i >= 0; --i) {
    if (shapes.frequency[i] != 0) continue;
    const Index last = group.count - ++group.straight;
    std::swap(shapes.frequency[i], shapes.frequency[last]);
    for (Index j = 0; j < group.count; ++j)
      std::swap(shapes.shape[group.count * i + j], shapes.shape[group.count * last + j]);
  }
  for (Index i = 0; i < group.modes(); ++i) {
    const double w = shapes.frequency[i];
    modes_.push_back(make_natural_mode(w, 0.5 * group.ratio * w * w));
  }
}

void Vibration::start(ConstState x) {
  motion_.resize(contacts_.size());
  for (auto& motion : motion_) {
    motion.depth.weight.assign(modes_.size(), {});
    motion.force.weight.assign(modes_.size(), {});
    motion.impulse.assign(modes_.size(), {});
  }
  for (const auto& group : groups_) {
    gather(group);
    depth_.clear();
    rate_.clear();
    for (const Index j : members(group)) {
      depth_.push_back(-x[contacts_[j].gap]);
      rate_.push_back(approach(j, x));
      for (auto* wave : {&motion_[j].depth, &motion_[j].force}) wave->constant = wave->slope = 0;
    }
    start_group(group);
    for (const Index j : members(group))
      for (std::size_t i = 0; i < modes_.size(); ++i)
        motion_[j].impulse[i] = integral(modes_[i], motion_[j].force.weight[i]);
  }
  for (Index j = 0; j < std::ssize(contacts_); ++j)
    if (!contacts_[j].pushes()) start_open(j, x);
}

double Vibration::misfit(ConstState x) const {
  double depth = 0, rate = 0, speed = 0;
  for (const auto& group : groups_)
    for (const Index j : group.ratio < 0 ? members(group) : std::span<const Index>()) {
      const auto& wave = motion_[j].depth;
      const Slope start = wave.slope_at(modes_, 0);
      depth = std::max(depth, std::abs(start.value + x[contacts_[j].gap]) / contacts_[j].length);
      rate = std::max(rate, std::abs(start.rate - approach(j, x)));
      double parts = 0;
      for (std::size_t i = 0; i < modes_.size(); ++i)
        parts += std::abs(dot(derivative(modes_[i], wave.weight[i]), values(modes_[i], 0)));
      speed = std::max(speed, parts);
    }
  return std::max(depth, speed > 0 ? rate / speed : 0);
}

/// δ = Σ U σ/√k and f = −√k Σ U σ̈/ω², free of the cancellation in k δ + c δ̇ where damping is strong.
void Vibration::ride_natural_modes(const VibrationGroup& group, const NaturalModes& shapes) {
  for (Index i = 0; i < group.modes(); ++i) {
    double value = 0, rate = 0;
    for (Index j = 0; j < group.count; ++j) {
      const double shape = std::sqrt(stiffness_[j]) * shapes.at(j, i);
      value += shape * depth_[j];
      rate += shape * rate_[j];
    }
    const Index place = group.first_mode + i;
    const auto& mode = modes_[place];
    const Weight motion = motion_from(mode, value, rate), bend = derivative(mode, derivative(mode, motion));
    const double square = shapes.frequency[i] * shapes.frequency[i];
    for (Index j = 0; j < group.count; ++j) {
      const double root = std::sqrt(stiffness_[j]), shape = shapes.at(j, i);
      auto& contact = motion_[members_[group.first + j]];
      contact.depth.weight[place] = {shape / root * motion.even, shape / root * motion.odd};
      contact.force.weight[place] = {-shape * root * bend.even / square, -shape * root * bend.odd / square};
    }
  }
}

/// An open or slack gap: straight, but for what closed contacts push. The straight part begins where what the
/// modes do leaves it to begin: pushes of a slow mode are large, and nearly cancel.
void Vibration::start_open(Index j, ConstState x) {
  auto& depth = motion_[j].depth;
  depth.constant = depth.slope = 0;
  add_pushes(j);
  const Slope modes = depth.slope_at(modes_, 0);
  depth.constant = -x[contacts_[j].gap] - modes.value;
  depth.slope = approach(j, x) - modes.rate;
  auto& load = motion_[j].force;  // k δ + c δ̇
  const double k = contacts_[j].stiffness, c = contacts_[j].damping;
  load.constant = k * depth.constant + c * depth.slope;
  load.slope = k * depth.slope;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const auto rate = derivative(modes_[i], depth.weight[i]);
    load.weight[i] = {k * depth.weight[i].even + c * rate.even, k * depth.weight[i].odd + c * rate.odd};
  }
}

/// The straight parts of all forces on a body that moves are in balance: only those of the modes count.
void Vibration::add_push(Index open_contact, Index closed_contact, double factor) {
  if (factor == 0) return;
  auto& depth = motion_[open_contact].depth;
  const auto& impulse = motion_[closed_contact].impulse;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const Weight push = integral(modes_[i], impulse[i]);
    depth.weight[i].even += factor * push.even;
    depth.weight[i].odd += factor * push.odd;
  }
}

}  // namespace mariotte::flow
