// One run, measured in a process of its own so that its memory is its own.
#pragma once
#include <cstddef>
#include <functional>

#include "mariotte/core/types.hpp"

namespace mariotte::scaling_study {

struct Measurement {
  double seconds = 0;  ///< CPU time
  double bytes = 0;    ///< most that was in use at one time, the chain itself included
  double error = 0;    ///< of the velocities at both ends; infinite if there was no answer
  Index steps = 0;
  Index widest = 0;  ///< contacts integrated together
};

/// What `run` measures, in a child process; `run` fills all but the bytes. Throws Error if it dies.
Measurement measured(const std::function<Measurement()>& run);

}  // namespace mariotte::scaling_study
