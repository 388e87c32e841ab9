// Which rates of bodies depend on which components of their state.
#pragma once
#include "mariotte/flow/problem.hpp"
#include "mariotte/model/bodies/bodies_mode.hpp"
#include "mariotte/model/bodies/bodies_setting.hpp"

namespace mariotte::model {

/// Places of the Jacobian that may not vanish in a mode, column by column. Impulses, losses and idle slots
/// change no rate.
template <int D>
std::vector<flow::Entry> pattern_of(const BodiesSetting<D>& setting, const BodiesLayout<D>& layout,
                                    const BodiesMode& mode);

}  // namespace mariotte::model
