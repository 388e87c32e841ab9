// Pairs that can meet soon: all others need not be watched until a body has gone half the skin.
#pragma once
#include "mariotte/model/bodies/bodies_setting.hpp"

namespace mariotte::model {

/// Whatever the bodies' attitudes, a gap is no smaller than that of balls around them.
template <int D>
double least_gap(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x,
                 const SettingContact<D>& contact);

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
