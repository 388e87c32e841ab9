// What a result was computed with, so that it can be computed again.
#pragma once
#include <string>

namespace mariotte::report {

struct Provenance {
  std::string version;     ///< of mariotte
  std::string sundials;    ///< version that is linked
  std::string compiler;    ///< name and version
  std::string build_type;  ///< CMake's word, for example "Release"
};

/// The provenance of this very program.
Provenance provenance();

/// Of the HDF5 that is linked; empty if the program was built without it.
std::string hdf5_version();

}  // namespace mariotte::report
