// What bounds the steps of series through contacts of bodies, recorded or compiled.
#pragma once
#include "mariotte/flow/series_flow.hpp"

namespace mariotte::flow {

/// So many steps, each shorter than this share of the natural time, lead towards a point that no series
/// passes: the slip of a spring in space where its contact opens, or a slip that comes to rest.
inline constexpr SeriesLimits contact_limits{.steps = 3000, .stalled = 12};
inline constexpr double short_step = 1e-3;
/// Guards compare forces, whose series are an order less sharp than those of the state.
inline constexpr double force_share = 0.1;
/// Times that a step is halved because what is not followed might fire in it.
inline constexpr int most_halvings = 3;

/// What the last terms of a step may be of the size of a state.
inline double most_of_last(double accuracy) {
  return series_share * force_share * accuracy;
}

}  // namespace mariotte::flow
