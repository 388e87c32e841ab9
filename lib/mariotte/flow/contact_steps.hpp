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

/// xᵏ, k ≥ 1.
inline double to_the(double x, int k) {
  const double half = k > 1 ? to_the(x, k / 2) : 1;
  return half * half * (k % 2 == 1 ? x : 1);
}

/// Largest place at which none of the last terms of series exceeds what it may; size(k) is the largest
/// coefficient k over its size. Most often the first of them decides, and the others take no root.
template <class Size>
double reach_of_last(std::span<const double> time, int order, double accuracy, Size&& size) {
  const double most = series_share * force_share * accuracy;
  double reach = infinity;
  const auto bound = [&](int first, int last) {
    for (int k = first; k <= last; ++k) {
      const double now = size(k);
      if (now * to_the(reach, k) > most) reach = std::pow(most / now, 1.0 / k);
    }
  };
  bound(order - last_terms + 1, order);
  if (begins_at_onset(time, reach)) bound(order - last_onset_terms + 1, order - last_terms);
  return reach;
}

}  // namespace mariotte::flow
