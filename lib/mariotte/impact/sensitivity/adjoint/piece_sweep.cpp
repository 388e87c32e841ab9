#include "mariotte/impact/sensitivity/adjoint/piece_sweep.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"

namespace mariotte::impact {
namespace {

constexpr int most_sweeps = 60;
constexpr double small = 1e-15;  ///< change by the last sweep

}  // namespace

PieceSweep::PieceSweep(const model::DimensionlessChain& chain, const MotionRecord& motion, RowSlopes& slopes)
    : chain_(chain),
      slopes_(slopes),
      piece_(motion.piece.end()),
      contact_(motion.contact.end()),
      rate_(motion.rate.end()),
      base_(chain.mass.size()),
      value_(chain.mass.size()),
      next_(chain.mass.size()),
      drift_(chain.mass.size()),
      pushes_(chain.law.size(), 0) {}

void PieceSweep::pass(const MotionRecord::Stretch& stretch) {
  --piece_;
  push_.resize(piece_->contacts);
  acting_ = piece_->contacts - piece_->shallow;
  for (auto own = push_.rbegin(); own != push_.rend(); ++own) take(*own);
  prepare(stretch);
  solve();
  finish(stretch);
}

/// The contact before the one that was taken last.
void PieceSweep::take(Push& own) {
  own.number = (--contact_)->number;
  own.depth = contact_->depth;
  own.rise = contact_->rise;
  own.fall = contact_->fall;
  const auto& power = law(own.number);
  own.rate = power.damping == 0 ? Nodes{} : *--rate_;
  for (int i = 0; i < stages; ++i) {
    const auto f = contact::smooth_force(power, own.depth[i], own.rate[i]);
    own.force[i] = piece_->pace[i] * f.value;
    own.by_depth[i] = piece_->pace[i] * f.by_indentation;
    own.by_rate[i] = piece_->pace[i] * f.by_rate;
  }
}

/// What λ_v would be if nothing pushed.
void PieceSweep::prepare(const MotionRecord::Stretch& stretch) {
  find_balls();
  for (const auto& own : acting()) pushes_[own.number] = 1;
  std::fill(drift_.begin() + stretch.first, drift_.begin() + stretch.last + 1, 0.0);
  for (Index j = stretch.first; j < stretch.last; ++j) {
    if (pushes_[j]) continue;
    drift_[j] += slopes_.gap[j];
    drift_[j + 1] -= slopes_.gap[j];
  }
  Nodes left{};  // until the end
  for (int j = 0; j < stages; ++j)
    for (int i = 0; i < stages; ++i) left[i] += until_end_.weight[j][i] * piece_->pace[j];
  for (const Index b : balls_)
    for (int i = 0; i < stages; ++i) value_[b][i] = base_[b][i] = slopes_.velocity[b] - drift_[b] * left[i];
}

void PieceSweep::find_balls() {
  balls_.clear();
  for (const auto& own : push_) {
    balls_.push_back(own.number);
    balls_.push_back(own.number + 1);
  }
  std::sort(balls_.begin(), balls_.end());
  balls_.erase(std::unique(balls_.begin(), balls_.end()), balls_.end());
}

/// λ in all points of a piece. What shallow contacts do to it is added to its end only.
void PieceSweep::solve() {
  double last = infinity, change = acting_ > 0 ? infinity : 0;
  for (int n = 0; n < most_sweeps && change > small && (n <= 8 || change < last); ++n) {
    last = change;
    for (const Index b : balls_) next_[b] = base_[b];
    for (auto& own : acting()) turn(own, slopes_.gap[own.number]);
    change = take_next();
  }
  if (!(change < 1e-12))
    throw InvalidParameter("slopes are not computed backwards: a contact is too strongly damped");
  for (auto own = push_.begin() + acting_; own != push_.end(); ++own) turn(*own, 0);
}

/// How much the last sweep has changed, relative to what it has found.
double PieceSweep::take_next() {
  double change = 0, largest = 0;
  for (const Index b : balls_)
    for (int i = 0; i < stages; ++i) {
      change = std::max(change, std::abs(next_[b][i] - value_[b][i]));
      largest = std::max(largest, std::abs(next_[b][i]));
      value_[b][i] = next_[b][i];
    }
  return largest > 0 ? change / largest : 0;
}

/// `held` is λ_g at the end, but for what drifts by it already.
void PieceSweep::turn(Push& own, double held) {
  const Index j = own.number;
  turn_contact_({.until_end = until_end_,
                 .left_mobility = chain_.inverse_mass[j],
                 .right_mobility = chain_.inverse_mass[j + 1],
                 .left = value_[j].data(),
                 .right = value_[j + 1].data(),
                 .by_depth = own.by_depth.data(),
                 .by_rate = own.by_rate.data(),
                 .pace = piece_->pace.data(),
                 .held = held,
                 .mu = own.mu.data(),
                 .gap_rate = own.gap_rate.data(),
                 .velocity_rate = own.velocity_rate.data(),
                 .next_left = next_[j].data(),
                 .next_right = next_[j + 1].data()});
}

void PieceSweep::finish(const MotionRecord::Stretch& stretch) {
  const double duration = total(piece_->pace);
  for (Index b = stretch.first; b <= stretch.last; ++b) slopes_.velocity[b] -= duration * drift_[b];
  for (const auto& own : push_) {
    const Index j = own.number;
    const double turned = total(own.velocity_rate);
    slopes_.gap[j] -= total(own.gap_rate);
    slopes_.velocity[j] -= turned;
    slopes_.velocity[j + 1] += turned;
    pushes_[j] = 0;
    add_slopes(own);
  }
}

/// ∫ λ·f_p dt of one contact.
void PieceSweep::add_slopes(const Push& own) {
  const Index j = own.number;
  const auto& power = law(j);
  double left = 0, right = 0;
  for (int i = 0; i < stages; ++i) {
    const double depth = own.depth[i], impulse = gauss.weight[i] * own.force[i];
    left += impulse * value_[j][i];
    right += impulse * value_[j + 1][i];
    if (power.exponent > 1 && !(depth > 0)) continue;
    const double mu = gauss.weight[i] * piece_->pace[i] * own.mu[i];
    const double width = contact::contact_width(power.exponent, depth);
    slopes_.stiffness[j] += mu * width * depth;
    slopes_.damping[j] += mu * width * own.rate[i];
    if (!(depth > 0)) continue;
    const double rest = own.rise * gauss.log_rest[i] + own.fall * gauss.log_rest[stages - 1 - i];
    slopes_.exponent[j] += (impulse * std::log(depth) + rest * own.force[i]) * own.mu[i];
  }
  const auto squared = [&](Index b) { return chain_.inverse_mass[b] * chain_.inverse_mass[b]; };
  slopes_.mass[j] += squared(j) * left;
  slopes_.mass[j + 1] -= squared(j + 1) * right;
}

}  // namespace mariotte::impact
