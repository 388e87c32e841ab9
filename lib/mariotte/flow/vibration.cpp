#include "mariotte/flow/vibration.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow {
namespace {

/// Largest condition of a root. Two roots that nearly meet are each wrong by it, and their amplitudes by its
/// square: 10⁻¹² at most.
constexpr double worst_condition = 100;

double common_ratio(std::span<const double> stiffness, std::span<const double> damping) {
  const double ratio = damping.front() / stiffness.front();
  for (std::size_t j = 1; j < stiffness.size(); ++j)
    if (std::abs(damping[j] - ratio * stiffness[j]) > 8 * epsilon * damping[j]) return -1;
  return ratio;
}

}  // namespace

double ContactMotion::impulse_at(const std::vector<Swing>& swing, double time) const {
  double sum = time * (force.constant + 0.5 * force.slope * time);
  for (std::size_t i = 0; i < impulse.size(); ++i) sum += dot(impulse[i], swing[i].change);
  return sum;
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

bool Vibration::find(const SerialPhase& phase) {
  find_islands(phase);
  natural_.resize(std::max(natural_.size(), islands_.size()));
  damped_.resize(std::max(damped_.size(), islands_.size()));
  modes_.clear();
  for (auto& island : islands_) {
    island.first_mode = static_cast<Index>(modes_.size());
    gather(phase, island);
    island.ratio = common_ratio(stiffness_, damping_);
    if (island.ratio >= 0)
      add_natural_modes(island);
    else if (!add_damped_modes(island))
      return false;
  }
  return true;
}

void Vibration::find_islands(const SerialPhase& phase) {
  islands_.clear();
  const auto is_wall = [&](Index body) { return phase.body[body].inverse_mass == 0; };
  const auto contacts = static_cast<Index>(phase.contact.size());
  for (Index j = 0; j < contacts; ++j) {
    if (!phase.contact[j].pushes()) continue;
    Index end = j + 1;
    while (end < contacts && phase.contact[end].pushes() && !is_wall(end)) ++end;
    islands_.push_back({j, end - j, 0, is_wall(j) && is_wall(end), 0});
    j = end - 1;
  }
}

void Vibration::gather(const SerialPhase& phase, const Island& island) {
  inverse_mass_.clear();
  stiffness_.clear();
  damping_.clear();
  for (Index j = island.first; j < island.first + island.count; ++j) {
    inverse_mass_.push_back(phase.body[j].inverse_mass);
    stiffness_.push_back(phase.contact[j].stiffness);
    damping_.push_back(phase.contact[j].damping);
  }
  inverse_mass_.push_back(phase.body[island.first + island.count].inverse_mass);
}

void Vibration::add_natural_modes(const Island& island) {
  auto& shapes = natural_[&island - islands_.data()];
  flow::find(shapes, inverse_mass_, stiffness_);
  if (island.between_walls) {  // what both walls fix does not vibrate: last, and left out
    const auto fixed = std::min_element(shapes.frequency.begin(), shapes.frequency.end());
    const Index column = fixed - shapes.frequency.begin(), last = island.count - 1;
    std::swap(*fixed, shapes.frequency.back());
    for (Index j = 0; j < island.count; ++j)
      std::swap(shapes.shape[island.count * column + j], shapes.shape[island.count * last + j]);
  }
  for (Index i = 0; i < island.count - island.between_walls; ++i) {
    const double w = shapes.frequency[i];
    modes_.push_back(make_mode(w, 0.5 * island.ratio * w * w));
  }
}

bool Vibration::add_damped_modes(const Island& island) {
  auto& shapes = damped_[&island - islands_.data()];
  if (!flow::find(shapes, row()) || !(shapes.condition < worst_condition)) return false;
  for (std::size_t i = 0; i < shapes.root.size(); ++i) {
    const auto value = shapes.root[i].value();
    const double decay = std::max(0.0, -value.real());
    if (value.imag() > 0)
      modes_.push_back({Mode::Form::oscillating, decay, value.imag()});
    else
      modes_.push_back({Mode::Form::separate, decay, -shapes.root[++i].value().real()});
  }
  return true;
}

void Vibration::start(const SerialPhase& phase, ConstState x) {
  const auto contacts = static_cast<Index>(phase.contact.size());
  motion_.resize(contacts);
  for (auto& motion : motion_) {
    motion.depth.weight.assign(modes_.size(), {});
    motion.force.weight.assign(modes_.size(), {});
    motion.impulse.assign(modes_.size(), {});
  }
  for (const auto& island : islands_) start_island(phase, island, x);
  for (Index j = 0; j < contacts; ++j)
    if (!phase.contact[j].pushes()) start_open(phase, j, x);
}

void Vibration::start_island(const SerialPhase& phase, const Island& island, ConstState x) {
  gather(phase, island);
  depth_.clear();
  rate_.clear();
  for (Index j = island.first; j < island.first + island.count; ++j) {
    depth_.push_back(-x[phase.contact[j].gap]);
    rate_.push_back(x[phase.body[j].velocity] - x[phase.body[j + 1].velocity]);
    for (auto* wave : {&motion_[j].depth, &motion_[j].force}) wave->constant = wave->slope = 0;
  }
  if (island.between_walls) take_straight_part(island);
  const Index place = &island - islands_.data();
  if (island.ratio >= 0)
    ride_natural_modes(island, natural_[place]);
  else
    ride_damped_modes(island, damped_[place]);
  for (Index j = island.first; j < island.first + island.count; ++j)
    for (std::size_t i = 0; i < modes_.size(); ++i)
      motion_[j].impulse[i] = integral(modes_[i], motion_[j].force.weight[i]);
}

/// Walls that come closer at a steady speed press all contacts between them with one force F₀ + F₁ t.
void Vibration::take_straight_part(const Island& island) {
  double compliance = 0, delay = 0, depth = 0, rate = 0;
  for (Index j = 0; j < island.count; ++j) {
    compliance += 1 / stiffness_[j];
    delay += damping_[j] / stiffness_[j] / stiffness_[j];
    depth += depth_[j];
    rate += rate_[j];
  }
  const double slope = rate / compliance, constant = (depth + slope * delay) / compliance;
  for (Index j = 0; j < island.count; ++j) {
    auto& motion = motion_[island.first + j];
    motion.force.constant = constant;
    motion.force.slope = slope;
    motion.depth.slope = slope / stiffness_[j];
    motion.depth.constant = (constant - damping_[j] * motion.depth.slope) / stiffness_[j];
    depth_[j] -= motion.depth.constant;
    rate_[j] -= motion.depth.slope;
  }
}

/// δ = Σ U σ/√k and f = −√k Σ U σ̈/ω², free of the cancellation in k δ + c δ̇ where damping is strong.
void Vibration::ride_natural_modes(const Island& island, const NaturalModes& shapes) {
  for (Index i = 0; i < island.count - island.between_walls; ++i) {
    double value = 0, rate = 0;
    for (Index j = 0; j < island.count; ++j) {
      const double shape = std::sqrt(stiffness_[j]) * shapes.at(j, i);
      value += shape * depth_[j];
      rate += shape * rate_[j];
    }
    const Index place = island.first_mode + i;
    const auto& mode = modes_[place];
    const Weight motion = motion_from(mode, value, rate), bend = derivative(mode, derivative(mode, motion));
    const double square = shapes.frequency[i] * shapes.frequency[i];
    for (Index j = 0; j < island.count; ++j) {
      const double root = std::sqrt(stiffness_[j]), shape = shapes.at(j, i);
      auto& contact = motion_[island.first + j];
      contact.depth.weight[place] = {shape / root * motion.even, shape / root * motion.odd};
      contact.force.weight[place] = {-shape * root * bend.even / square, -shape * root * bend.odd / square};
    }
  }
}

/// The real part of 2 a e^{λt} off the axis, a e^{λt} on it.
void Vibration::ride_damped_modes(const Island& island, const DampedModes& shapes) {
  const auto damped_row = row();
  const auto amplitude = [&](Index root) { return shapes.amplitude(damped_row, root, depth_, rate_); };
  const Index count = island.count;
  Index place = island.first_mode;
  for (Index i = 0; i < static_cast<Index>(shapes.root.size()); ++i, ++place) {
    const auto first = amplitude(i);
    const double turn = shapes.root[i].value().imag();
    const auto second = turn > 0 ? 0.0 : amplitude(i + 1);
    const auto weight = [&](const std::vector<std::complex<double>>& shape, Index j) -> Weight {
      const auto z = first * shape[count * i + j];
      if (turn > 0) return {2 * z.real(), -2 * turn * z.imag()};
      return {z.real(), (second * shape[count * (i + 1) + j]).real()};
    };
    for (Index j = 0; j < count; ++j) {
      motion_[island.first + j].depth.weight[place] = weight(shapes.depth, j);
      motion_[island.first + j].force.weight[place] = weight(shapes.force, j);
    }
    if (!(turn > 0)) ++i;
  }
}

/// An open or slack gap: straight, but for the pushes on its two bodies from their other sides.
void Vibration::start_open(const SerialPhase& phase, Index j, ConstState x) {
  auto& depth = motion_[j].depth;
  const auto &left = phase.body[j], &right = phase.body[j + 1];
  depth.constant = -x[phase.contact[j].gap];
  depth.slope = x[left.velocity] - x[right.velocity];
  if (j > 0 && phase.contact[j - 1].pushes()) add_push(depth, motion_[j - 1], left.inverse_mass);
  if (j + 1 < static_cast<Index>(phase.contact.size()) && phase.contact[j + 1].pushes())
    add_push(depth, motion_[j + 1], right.inverse_mass);
  auto& load = motion_[j].force;  // k δ + c δ̇
  const double k = phase.contact[j].stiffness, c = phase.contact[j].damping;
  load.constant = k * depth.constant + c * depth.slope;
  load.slope = k * depth.slope;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const auto rate = derivative(modes_[i], depth.weight[i]);
    load.weight[i] = {k * depth.weight[i].even + c * rate.even, k * depth.weight[i].odd + c * rate.odd};
  }
}

/// Adds factor · ∫∫ f dt dt of a closed contact. Between walls all its forces but those of modes balance.
void Vibration::add_push(Wave& depth, const ContactMotion& neighbour, double factor) const {
  if (factor == 0) return;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const Weight push = integral(modes_[i], neighbour.impulse[i]);
    const Weight now = {1, modes_[i].form == Mode::Form::separate ? 1.0 : 0.0};
    depth.constant -= factor * dot(push, now);
    depth.slope -= factor * dot(neighbour.impulse[i], now);
    depth.weight[i].even += factor * push.even;
    depth.weight[i].odd += factor * push.odd;
  }
}

}  // namespace mariotte::flow
