// Decaying oscillations over a straight line: first root and largest value, found so that none can be
// skipped.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/flow/mode.hpp"

namespace mariotte::flow {

/// A value and its rate.
struct Slope {
  double value;
  double rate;
};

/// f(t) = constant + slope t + Σ weightᵢ · modeᵢ(t). The modes are shared by all waves of a phase.
struct Wave {
  double constant = 0;
  double slope = 0;
  std::vector<Weight> weight;

  double at(const std::vector<NaturalMode>& modes, double time) const;
  Slope slope_at(const std::vector<NaturalMode>& modes, double time) const;
};

/// First time in (from, to] at which the wave falls through zero; empty if there is none. Intervals are
/// halved until bounds of value or rate decide them, so that no root is skipped and what oscillates too
/// little to matter is never resolved: the cost does not grow with the highest frequency. A value of zero at
/// `from` is no root if the wave rises from it.
std::optional<double> first_fall(const Wave& wave, const std::vector<NaturalMode>& modes, double from,
                                 double to);

/// Where a wave is largest, and how far around it is concave.
struct Summit {
  double time;
  double reach;
};

/// The largest maximum inside (from, to), to rounding in the value; empty if an end is as high. Branch and
/// bound: intervals that cannot hold anything higher than what is known are left alone. Of very many maxima
/// that are nearly equal it may be another.
std::optional<Summit> highest(const Wave& wave, const std::vector<NaturalMode>& modes, double from,
                              double to);

}  // namespace mariotte::flow
