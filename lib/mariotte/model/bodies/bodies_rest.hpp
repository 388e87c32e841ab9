// Bodies that rest, or roll on, while they press each other.
#pragma once
#include "mariotte/model/bodies/bodies_field.hpp"

namespace mariotte::model {

/// Friction, or adhesion and a damper, hold for ever what touches in this mode, unless something else comes:
/// it rests, or rolls on as it does, and what forces change in a natural time is rounding. False where a run
/// has a limit in time, under gravity, and beside moving planes.
template <int D>
bool is_held(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, const BodiesMode& mode, ConstState x,
             BodiesField<double, D>& field);

}  // namespace mariotte::model
