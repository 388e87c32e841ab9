// A run that may neither hang nor bring the study down.
#pragma once
#include "measure.hpp"

namespace mariotte::stiffness_study {

/// `measure` in a process of its own that is ended after `limit` seconds of CPU time, repetitions included.
/// What was ended so has the ending "-"; a process that died otherwise, "failed".
Run guarded(const ImpactCase& one, const Request& request, double limit);

}  // namespace mariotte::stiffness_study
