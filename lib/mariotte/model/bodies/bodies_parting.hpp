// Whether a contact is at its end.
#pragma once
#include "mariotte/model/bodies/bodies_mode.hpp"
#include "mariotte/model/bodies/bodies_motion.hpp"
#include "mariotte/model/bodies/law_numbers.hpp"

namespace mariotte::model {

/// Depth within which a gap is rounding: a place is a sum of steps, and does not change by steps that are so
/// much shorter than itself.
template <int D>
double gap_rounding(const BodiesSetting<D>& setting, const BodiesLayout<D>& at,
                    const SettingContact<D>& contact, ConstState x) {
  constexpr double steps = 4096;
  const auto way = [&](Index sphere) { return norm(vec_at<D>(x, at.shift(setting.sphere[sphere].body))); };
  return steps * epsilon * (way(contact.b) + (contact.plane < 0 ? way(contact.a) : 0));
}

/// What Mindlin's spring loses on unloading grows without bound towards the end of its contact.
template <int D>
bool fades(const BodiesSetting<D>& setting, const ClosedContact& one) {
  return one.unloading && !one.slack && setting.contact[one.contact].tangential.law == TangentialLaw::mindlin;
}

/// Whether the two of a closed contact leave each other beyond its end; where its spring fades, within
/// rounding of it.
template <int D>
bool has_parted(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, const ClosedContact& one,
                ConstState x) {
  const auto& contact = setting.contact[one.contact];
  const auto now = gap_motion(setting, at, contact, x);
  const double left = -now.gap - opening_depth(contact.law, one.past);
  const double rounding = fades(setting, one) ? gap_rounding(setting, at, contact, x) : 0;
  return left <= rounding && now.gap_rate > setting.slip_noise * setting.speed;
}

}  // namespace mariotte::model
