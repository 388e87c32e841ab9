#include "mariotte/flow/modal/modal_step.hpp"

#include <algorithm>

namespace mariotte::flow {
namespace {

double integral_of(const Overlap& product, const Weight& left, const Weight& right) {
  return left.even * (product.even_even * right.even + product.even_odd * right.odd) +
         left.odd * (product.odd_even * right.even + product.odd_odd * right.odd);
}

}  // namespace

void ModalStep::at(double time, State x) const {
  const auto& modes = vibration_.modes();
  for (std::size_t i = 0; i < modes.size(); ++i) workspace_.swing[i] = swing(modes[i], time);
  std::copy(origin_.begin(), origin_.end(), x.begin());
  const auto contacts = vibration_.contacts();
  for (std::size_t j = 0; j < contacts.size(); ++j) {
    const auto& c = contacts[j];
    const auto& motion = vibration_.of(j);
    x[c.gap] = 0 - value(motion.depth, time);  // never −0
    if (!c.pushes()) continue;
    const double p = motion.impulse_at(workspace_.swing, time);
    vibration_.add_impulse(j, p, x);
    if (c.impulse >= 0) x[c.impulse] += p;
  }
  for (const auto& group : vibration_.groups())
    if (group.ratio != 0) add_work(group, time, x);
}

double ModalStep::value(const Wave& wave, double time) const {
  double sum = wave.constant + wave.slope * time;
  for (std::size_t i = 0; i < wave.weight.size(); ++i) sum += dot(wave.weight[i], workspace_.swing[i].value);
  return sum;
}

/// ∫ f δ̇ dt, with f and δ̇ sums over the modes of the group.
void ModalStep::add_work(const VibrationGroup& group, double time, State x) const {
  for (Index i = group.first_mode; i < group.first_mode + group.modes(); ++i) {
    workspace_.progress[i] = progress(vibration_.modes()[i], time);
    for (Index k = group.first_mode; k <= i; ++k) add_product(group, i, k, time, x);
  }
  if (group.straight == 0) return;
  for (const Index j : vibration_.members(group))
    if (const Index work = vibration_.contacts()[j].work; work >= 0)
      x[work] += straight_work(group, vibration_.of(j), time);
}

/// What two modes do together.
void ModalStep::add_product(const VibrationGroup& group, Index i, Index k, double time, State x) const {
  const auto& modes = vibration_.modes();
  const auto product = overlap(workspace_.progress[i], workspace_.progress[k], time);
  for (const Index j : vibration_.members(group)) {
    if (vibration_.contacts()[j].work < 0) continue;
    const auto &force = vibration_.of(j).force.weight, &depth = vibration_.of(j).depth.weight;
    double& work = x[vibration_.contacts()[j].work];
    work += integral_of(product, force[i], derivative(modes[k], depth[k]));
    if (k != i) work += integral_of(product, derivative(modes[i], depth[i]), force[k]);
  }
}

/// What the straight parts F₀ + F₁ t of the force and v t of the indentation add:
/// ∫ (F₀ + F₁ t)(v + δ̇) + v f dt, with f and δ of the modes.
double ModalStep::straight_work(const VibrationGroup& group, const ContactMotion& motion, double time) const {
  const auto &force = motion.force, &depth = motion.depth;
  double work = depth.slope * time * (force.constant + 0.5 * force.slope * time);
  for (Index i = group.first_mode; i < group.first_mode + group.modes(); ++i) {
    const auto& weight = depth.weight[i];
    const auto& now = workspace_.swing[i];
    const auto sum = integral(vibration_.modes()[i], weight);
    work += force.constant * dot(weight, now.change) + depth.slope * dot(motion.impulse[i], now.change);
    work += force.slope * (time * dot(weight, now.value) - dot(sum, now.change));
  }
  return work;
}

}  // namespace mariotte::flow
