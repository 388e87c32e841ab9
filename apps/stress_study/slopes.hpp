// Slopes of a scene, against differences of runs that are as exact as can be.
#pragma once
#include "examine.hpp"
#include "slope_subject.hpp"

namespace mariotte::stress_study {

/// The slopes of a scene at all `accuracies`, and what is wrong with them; `brisk`: unless they take long.
Verdict examine_slopes(const SlopeSubject& subject, std::uint64_t number, const Announce& announce,
                       bool brisk);

}  // namespace mariotte::stress_study
