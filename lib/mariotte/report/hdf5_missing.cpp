// What stands for report/hdf5 in a program that is built without HDF5.
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/page/provenance.hpp"
#include "mariotte/report/sweep_file.hpp"
#include "mariotte/report/trace_file.hpp"

namespace mariotte::report {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw FileError("cannot write " + path.string() + ": built without HDF5; CSV is written without it",
                  fault::unwritable, path.string());
}

}  // namespace

std::string hdf5_version() {
  return "";
}

std::unique_ptr<TraceFile> new_hdf5_trace(const std::filesystem::path& path, const std::vector<Index>&,
                                          const std::vector<Index>&, const Attributes&) {
  refuse(path);
}

void write_hdf5_columns(const std::filesystem::path& path, const std::string&, const Attributes&) {
  refuse(path);
}

std::unique_ptr<SweepFile> new_hdf5_sweep(const std::filesystem::path& path, const study::Design&,
                                          const std::vector<study::Column>&, const Attributes&) {
  refuse(path);
}

}  // namespace mariotte::report
