// Sums of sines over a straight line, and their first root, found so that none can be skipped.
#pragma once
#include <optional>
#include <vector>

namespace mariotte::flow {

/// One mode of vibration, R sin(ω t + φ).
struct Mode {
  double amplitude;
  double frequency;
  double phase;

  double at(double time) const;
  double rate(double time) const;
};

/// f(t) = constant + slope t + Σ weightᵢ modeᵢ(t). The modes are shared by all waves of a phase.
struct Wave {
  double constant = 0;
  double slope = 0;
  std::vector<double> weight;

  double at(const std::vector<Mode>& modes, double time) const;
  double rate(const std::vector<Mode>& modes, double time) const;
};

/// First time in (from, to] at which the wave falls through zero; empty if there is none. Intervals are
/// halved until bounds of value or rate decide them, so that no root is skipped. Modes that are slow against
/// the interval enter as one Taylor polynomial, in which they cancel as they should, bounded by its Bernstein
/// coefficients; fast ones enter by their range, so that what oscillates too little to matter is never
/// resolved and the cost does not grow with the highest frequency. A value of zero at `from` is no root if
/// the wave rises from it.
std::optional<double> first_fall(const Wave& wave, const std::vector<Mode>& modes, double from, double to);

}  // namespace mariotte::flow
