// Pairs that can meet soon: all others need not be watched until a body has gone half the skin.
#pragma once
#include "mariotte/model/bodies/bodies_setting.hpp"

namespace mariotte::model {

/// Whatever the bodies' attitudes, a gap is no smaller than that of balls around them.
template <int D>
double least_gap(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x,
                 const SettingContact<D>& contact);

/// Whether a few natural indentations do not close a contact.
template <int D>
bool is_far(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x,
            const SettingContact<D>& contact) {
  constexpr double far = 4;
  return least_gap(setting, at, x, contact) > far * contact.length;
}

/// Whether a contact cannot close within a time from x on, in which each body goes no farther than its reach.
template <int D>
bool stays_open(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x,
                const SettingContact<D>& contact, double time, std::span<const double> reach);

/// How far a body in free flight goes within a time, at most.
template <int D>
double flown(const BodiesSetting<D>& setting, const Vec<double, D>& velocity, double time) {
  return time * (norm(velocity) + 0.5 * time * norm(setting.gravity));
}

/// Make the list anew where it is missing, or a body has gone too far since. Contacts with planes are always
/// near.
template <int D>
void refresh_near(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x, BodiesMode& mode);

/// True if the list is what is watched in this mode.
template <int D>
bool watches_near(const BodiesSetting<D>& setting, const BodiesMode& mode) {
  return setting.skin > 0 && !mode.closed.empty() && mode.touching.empty() && !mode.from.empty();
}

}  // namespace mariotte::model
