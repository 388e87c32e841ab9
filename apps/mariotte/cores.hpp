// How much this process may do at once.
#pragma once

namespace mariotte::command {

/// The cores it may run on: what mpirun or a batch system bound it to.
int cores();

}  // namespace mariotte::command
