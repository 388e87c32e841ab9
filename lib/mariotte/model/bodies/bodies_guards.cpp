// What ends a mode of bodies, over any number.
#include <algorithm>

#include "mariotte/model/bodies/bodies_phase.hpp"

namespace mariotte::model {

using flow::Crossing;

/// By which a spring may exceed its cap. A law with branches may be much stiffer than its natural force says:
/// rounding of its depth then moves the cap by more than a share of that force. So does the depth of an
/// onset, which is rounding, where a damper's force begins like a small power of it.
template <int D>
template <class T>
double BodiesPhase<D>::cap_noise(const ClosedContact& mode, const ContactMotion<T, D>& motion) const {
  const auto& one = setting_.contact[mode.contact];
  const double share = setting_.slip_noise * one.force;
  const double depth = -series::value_of(motion.gap), rate = -series::value_of(motion.gap_rate);
  if (depth < mode.gap_noise && rate > 0) {
    const auto force = [&](double at) { return smooth_force(one.law, mode.past, at, rate).value; };
    return std::max(share, one.tangential.friction * std::abs(force(mode.gap_noise) - force(0)));
  }
  if (!contact::branched(one.law)) return share;
  const double stiffness = smooth_force(one.law, mode.past, depth, rate).by_indentation;
  return std::max(share, one.tangential.friction * std::abs(stiffness) * setting_.rounding * one.length);
}

/// Guards that start at zero or return to it have an offset as large as noise: they fire once they are
/// beyond.
template <int D>
template <class T, class N>
T BodiesPhase<D>::friction_guard(const BodiesField<T, D, N>& field, const ClosedContact& mode,
                                 const ContactForces<T, D>& c) const {
  const auto& one = field.setting().contact[mode.contact];
  const double noise = setting_.slip_noise;
  if (mode.friction == Friction::none || mode.slack) return T(1.0);
  if constexpr (is_recorded<T>) {  // without the root of a square
    if (mode.friction == Friction::stick) {
      const double offset = noise * one.force;
      const T cap = one.tangential.friction * c.normal, left = cap * cap - dot(c.friction, c.friction);
      if (contact::branched(one.law)) {
        const T most = cap + cap_noise(mode, c.motion);
        return most * most - dot(c.friction, c.friction);
      }
      const double least = setting_.faint_stick() * one.force;
      if (!one.tangential.has_spring()) return left + 2 * offset * cap + least * least;
      return left + 2 * noise * cap.value() * cap + offset * offset;
    }
    const double rest = setting_.rest_speed();
    if (D == 3 && !one.tangential.has_spring()) return dot(c.motion.slip, c.motion.slip) - rest * rest;
  }
  if (mode.friction == Friction::stick)
    return one.tangential.friction * c.normal - norm(c.friction) + cap_noise(mode, c.motion);
  if (one.tangential.has_spring()) return field.yielding(mode, c) + noise * setting_.speed;
  if constexpr (D == 2)
    return dot(c.motion.slip, c.direction) + noise * setting_.speed;
  else
    return norm(c.motion.slip) - setting_.rest_speed();
}

/// What has pulled pushes again once its force is beyond noise: in its well that comes to zero and stays
/// there.
template <int D>
template <class T, class N>
T BodiesPhase<D>::load_guard(const BodiesField<T, D, N>& field, const ClosedContact& mode,
                             const ContactForces<T, D>& c) const {
  const auto& one = field.setting().contact[mode.contact];
  if (contact::pulls(one.law)) return mode.slack ? c.normal - setting_.gap_noise * one.force : c.normal;
  if (!contact::goes_slack(one.law)) return T(1.0);
  const T load = law_load<T>(one, c.motion.indentation, -c.motion.gap_rate);
  return mode.slack ? load : load + load_noise<T>(one.law, setting_.rest_speed());
}

/// Of closed contact i.
template <int D>
template <class T, class N>
void BodiesPhase<D>::slot_guards(const BodiesField<T, D, N>& field, std::size_t i,
                                 std::span<T> values) const {
  const auto& one = mode_->closed[i];
  const auto& c = field.contact(i);
  const auto set = [&](SlotGuard guard, const T& value) { values[slot_guard(one.slot, guard)] = value; };
  const auto& law = setting_.contact[one.contact].law;
  const double noise = setting_.slip_noise * setting_.speed;
  // While it is pressed steps may be shorter than rounding of its gap; but series follow the gap itself.
  const double noise_of_onset = is_recorded<T> || one.unloading ? 0 : one.gap_noise;
  set(SlotGuard::open, c.motion.gap + opening_depth(law, one.past) - noise_of_onset);
  set(SlotGuard::friction, friction_guard(field, one, c));
  set(SlotGuard::turn, -c.motion.gap_rate + (one.unloading ? -noise : noise));
  set(SlotGuard::load, load_guard(field, one, c));
  if (crossing_[slot_guard(one.slot, SlotGuard::yield)] != Crossing::none)
    set(SlotGuard::yield, c.motion.gap + yield_depth(law, one.past));
}

template <int D>
template <class T, class N>
void BodiesPhase<D>::guards_of(const BodiesField<T, D, N>& field, std::span<T> values) const {
  std::fill(values.begin(), values.end(), T(1.0));
  for (Index k = 0; k < watched_count(); ++k) {
    if (crossing_[gap_guard(k)] == Crossing::none || (is_recorded<T> && is_far_[k])) continue;
    values[gap_guard(k)] = field.approach(watched(k)).gap + closing_depth(watched(k));
  }
  for (Index k = 0; k < escapes_; ++k)
    values[escape_guard(k)] = field.approach(watched(k)).gap - escape_gap(watched(k));
  for (Index i = 0; i < strays_; ++i) {
    const auto gone = field.body(i).shift - lift<T>(vec_at<D>(ConstState(mode_->from), D * i));
    values[stray_guard(i)] = 0.25 * setting_.skin * setting_.skin - dot(gone, gone);
  }
  for (std::size_t i = 0; i < mode_->closed.size(); ++i) slot_guards(field, i, values);
  for (Index k = 0; k < std::ssize(mode_->touching); ++k) {
    const Index c = mode_->touching[k];
    const double depth = setting_.gap_noise * setting_.contact[c].length;
    const T gap = values[gap_guard(c)];
    values[parting_guard(k)] = gap - depth;
    values[gap_guard(c)] = gap + depth;
  }
}

template <int D>
void BodiesPhase<D>::guards(ConstState x, State values) const {
  field_.evaluate(layout_, *mode_, x);
  guards_of<double>(field_, values);
}

template <int D>
void BodiesPhase<D>::derivative_and_guards(ConstState x, State dx, State values) const {
  derivative(x, dx);
  guards_of<double>(field_, values);
}

template <int D>
void BodiesPhase<D>::guard_rates(ConstState x, ConstState dx, State rates) const {
  using Along = series::Dual<double, 1>;
  along_.resize(x.size());
  along_values_.resize(rates.size());
  for (std::size_t i = 0; i < x.size(); ++i) along_[i] = Along(x[i], {dx[i]});
  directional_.evaluate(layout_, *mode_, std::span<const Along>(along_));
  guards_of<Along>(directional_, along_values_);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = along_values_[i].slope[0];
}

template void BodiesPhase<2>::guards(ConstState, State) const;
template void BodiesPhase<3>::guards(ConstState, State) const;
template void BodiesPhase<2>::derivative_and_guards(ConstState, State, State) const;
template void BodiesPhase<3>::derivative_and_guards(ConstState, State, State) const;
template void BodiesPhase<2>::guard_rates(ConstState, ConstState, State) const;
template void BodiesPhase<3>::guard_rates(ConstState, ConstState, State) const;
template void BodiesPhase<2>::guards_of(const BodiesField<series::Traced, 2>&,
                                        std::span<series::Traced>) const;
template void BodiesPhase<3>::guards_of(const BodiesField<series::Traced, 3>&,
                                        std::span<series::Traced>) const;
template void BodiesPhase<2>::guards_of(const BodiesField<Sloped, 2, Sloped>&, std::span<Sloped>) const;
template void BodiesPhase<3>::guards_of(const BodiesField<Sloped, 3, Sloped>&, std::span<Sloped>) const;

}  // namespace mariotte::model
