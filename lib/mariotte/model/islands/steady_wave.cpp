#include "mariotte/model/islands/steady_wave.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/bracket.hpp"

namespace mariotte::model {
namespace {

/// Every other one of `count` values.
struct Values {
  const double* first;
  Index count;
};

double largest(Values values) {
  double size = 0;
  for (Index i = 0; i < values.count; i += 2) size = std::max(size, std::abs(values.first[i]));
  return size;
}

double difference(Values a, Values b) {
  double apart = 0;
  for (Index i = 0; i < a.count; i += 2) apart = std::max(apart, std::abs(a.first[i] - b.first[i]));
  return apart;
}

/// Largest difference to one value.
double difference(Values a, double b) {
  double apart = 0;
  for (Index i = 0; i < a.count; i += 2) apart = std::max(apart, std::abs(a.first[i] - b));
  return apart;
}

}  // namespace

bool shows_same_wave(const WaveStamp& before, const WaveStamp& now, double tolerance) {
  const Index a = now.crest - now.first, b = before.crest - before.first;  // contacts up to the crest
  const Index left = std::min(a, b), size = std::ssize(now.state);
  const Index right = std::min(size / 2 - a, std::ssize(before.state) / 2 - b);
  const Index begin = 2 * (a - left), count = 2 * (left + right) + 1, end = begin + count;
  const double *x = now.state.data(), *y = before.state.data() + 2 * (b - left);
  const double rest = now.crest > before.crest ? x[size - 1] : x[0];
  const double slow = tolerance * largest({x, size}), shallow = tolerance * largest({x + 1, size - 1});
  return difference(Values{x + begin, count}, Values{y, count}) <= slow &&
         difference(Values{x + begin + 1, count - 1}, Values{y + 1, count - 1}) <= shallow &&
         difference(Values{x, begin}, rest) <= slow &&
         difference(Values{x + end + 1, size - end - 1}, rest) <= slow;
}

bool lets_waves_be_steady(const contact::Law& law) {
  const auto* power = power_law(law);
  return power && power->damping == 0 && power->exponent > 1;
}

bool are_equal(const DimensionlessChain& chain, Index j, Index shift) {
  if (chain.is_faint[j] || chain.is_faint[j + shift]) return false;  // its impulse is followed
  if (!lets_waves_be_steady(chain.law[j]) || !lets_waves_be_steady(chain.law[j + shift])) return false;
  const auto &a = *power_law(chain.law[j]), &b = *power_law(chain.law[j + shift]);
  return a.stiffness == b.stiffness && a.exponent == b.exponent && chain.mass[j] == chain.mass[j + shift] &&
         chain.noise_depth[j] == chain.noise_depth[j + shift] && chain.gravity[j] == 0 &&
         chain.gravity[j + shift] == 0;
}

void CrestObserver::begin(const ChainSystem& slice, ConstState start, flow::StepObserver* other) {
  layout_ = &slice.layout();
  other_ = other;
  contact_ = -1;
  time_ = -1;
  double deepest = 0;
  for (Index j = 0; j < layout_->contacts(); ++j) {
    const double depth = -start[layout_->gap[j]];
    const auto loads = [&] { return start[layout_->velocity[j]] > start[layout_->velocity[j + 1]]; };
    if (depth > deepest && loads()) deepest = depth, contact_ = j;
  }
}

double CrestObserver::rate(ConstState x) const {
  return x[layout_->velocity[contact_]] - x[layout_->velocity[contact_ + 1]];
}

void CrestObserver::observe(const flow::Step& step) {
  if (other_) other_->observe(step);
  if (contact_ < 0 || has_seen()) return;
  const double before = rate(step.before), after = rate(step.after);
  if (!(before > 0 && after <= 0)) return;
  state_.resize(step.before.size());
  const auto rate_at = [&](double time) {
    step.at(time, state_);
    return rate(state_);
  };
  time_ = locate_sign_change(rate_at, step.start, before, step.end, after, epsilon * (step.end - step.start));
  step.at(time_, state_);
}

}  // namespace mariotte::model
