// Runs with slopes that have as many digits as slopes of what is asked need.
#pragma once
#include <algorithm>
#include <tuple>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/sensitivity/notes.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::impact {

/// Slopes ask for the second derivatives of what the run is computed from: it has so small a share of their
/// errors.
inline constexpr double slope_share = 0.01;

inline hybrid::Options for_slopes(hybrid::Options options) {
  options.accuracy = std::max(1e-14, slope_share * options.accuracy);
  return options;
}

/// How many times the error of a run some slopes have, and what is said where doubles have no more digits.
struct SlopeLoss {
  double times;
  SlopeNote (*note)(double error);
};

/// `once` is a run with slopes at an accuracy, and how many times its error some of them have; pieces may
/// leave ten times as much. Where that is more than was asked, another run has more digits; `note(error)`
/// tells if doubles do not have so many.
template <class Once, class Note>
Sensitivity resolved(const hybrid::Options& asked, Once&& once, Note&& note) {
  constexpr double left = 10, least = 16 * epsilon;
  auto options = for_slopes(asked);
  auto [found, loss] = once(options);
  if (!(left * options.accuracy * loss > asked.accuracy)) return found;
  options.accuracy = std::clamp(asked.accuracy / (left * loss), least, options.accuracy);
  std::tie(found, loss) = once(options);
  const double error = left * options.accuracy * loss;
  if (error > 2 * asked.accuracy) add_doubt(note(error), found);
  return found;
}

}  // namespace mariotte::impact
