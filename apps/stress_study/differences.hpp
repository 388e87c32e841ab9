// Slopes by differences of order eight of runs, with steps of several lengths.
#pragma once
#include <vector>

#include "slope_subject.hpp"

namespace mariotte::stress_study {

/// What outcomes are compared with: the speed, the largest impulse and spin or those of the subject, their
/// own value. Zero of those that follow from others.
std::vector<double> outcome_sizes(const impact::Sensitivity& slopes, const SlopeSubject& subject);

/// Slopes in natural units, and by how much those of two steps differ. Empty if no step leaves the run what
/// it is.
struct Estimate {
  std::vector<double> slope, doubt;
};

/// From points on both sides, and on each side alone.
struct Differences {
  Estimate both, left, right;

  /// The slopes that outcome i may have: one, or that of either side if the number stands next to a kink,
  /// such as where two events change places. Each side then has its own, and what both say together has none.
  std::vector<const Estimate*> of(std::size_t i) const;
};
/// `steepness` is that of the steepest outcome: longer steps leave its slope.
Differences differences(const Probe& probe, const impact::Sensitivity& base, const std::vector<double>& sizes,
                        double steepness);

}  // namespace mariotte::stress_study
