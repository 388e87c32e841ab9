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

/// Columns of a pattern that share no row have one colour, from 0: their slopes can be told apart when they
/// are carried together. By column; −1 of one that changes nothing [Curtis, Powell & Reid 1974].
std::vector<Index> colours_of(const std::vector<flow::Entry>& pattern, Index columns);

}  // namespace mariotte::model
