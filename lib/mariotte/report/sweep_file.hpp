// The rows of a sweep on their way to a file that is not the CSV.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/report/attributes.hpp"
#include "mariotte/study/sweep/columns.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::report {

/// Under a temporary name until `commit`; without it nothing is left behind. All throw FileError.
class SweepFile {
 public:
  virtual ~SweepFile() = default;
  virtual void add(std::string_view rows) = 0;  ///< lines of the CSV, in the order of the points
  virtual void commit() = 0;
};

/// HDF5 with one dataset per column of the CSV and of its name, each with one value per point: numbers, nan
/// where there is none; text for `ending`, `reason` and what is varied over text. Columns have attributes
/// `units` (SI), `symbol` and `long_name`, and the axis `point`, numbers from 0. The attribute `shape` of the
/// file says how many points lie along each axis of the sweep, the last one fastest; `origin` are more
/// attributes of the file. Throws FileError where the
/// program was built without HDF5.
std::unique_ptr<SweepFile> new_hdf5_sweep(const std::filesystem::path& path, const study::Design& design,
                                          const std::vector<study::Column>& columns,
                                          const Attributes& origin = {});

}  // namespace mariotte::report
