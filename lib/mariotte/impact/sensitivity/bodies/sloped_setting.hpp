// The numbers of bodies with their slopes by parameters: what the field of bodies makes of them then has
// slopes at a fixed state.
#pragma once
#include <array>
#include <vector>

#include "mariotte/impact/sensitivity/stencil.hpp"
#include "mariotte/model/bodies/bodies_motion.hpp"

namespace mariotte::impact {

/// By as many parameters as slopes are carried side by side.
template <int D>
using SlopedSetting = model::BodiesSetting<D, model::Sloped>;

/// The bodies at the points of the stencil around one parameter.
template <int D>
struct ShiftedSettings {
  double step;
  std::array<model::BodiesSetting<D>, stencil.size()> at;
};

/// Throws InvalidParameter unless forces are those of power laws, whose exponents stay, and moments that are
/// equal stay so.
template <int D>
std::vector<SlopedSetting<D>> sloped_settings(const model::BodiesSetting<D>& base,
                                              const std::vector<ShiftedSettings<D>>& shifted);

}  // namespace mariotte::impact
