// The same impacts by LAMMPS, if it is installed: how near its steps come, and at what cost.
#pragma once
#include <string>

#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Lines of two balls with a law that LAMMPS has: its largest error of velocities and of spins × radius, over
/// the speed of approach, with steps that are halved, and the run time of both. A line that says so where no
/// program `lmp` is found.
std::string beside_lammps(const measuring::Patience& patience);

}  // namespace mariotte::work_precision
