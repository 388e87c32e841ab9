// How HDF5 reaches the disk here: what cannot be written is remembered and not reported to HDF5.
//
// HDF5 cannot close a file whose writing has failed: its bookkeeping keeps the closed file and closes it
// again when the program ends, which is a crash. So it never hears of a failure. What the disk refuses is
// kept in memory, where HDF5 finds it again while it closes the file, and the owner of the file asks for the
// problem.
#pragma once
#include <H5Cpp.h>

namespace mariotte::report::hdf5 {

/// Properties to open one file with. `problem` is set to the first errno that its writing meets and stays 0
/// without one; it has to live until the file and all its datasets are closed.
H5::FileAccPropList remembering(int& problem);

}  // namespace mariotte::report::hdf5
