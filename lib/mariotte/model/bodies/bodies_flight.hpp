// One body in free flight.
#pragma once
#include "mariotte/model/bodies/bodies_setting.hpp"

namespace mariotte::model {

/// The places of body i in `result`, a time t after x.
template <int D>
void fly(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x, Index i, double t,
         State result);

}  // namespace mariotte::model
