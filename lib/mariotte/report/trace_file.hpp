// A trace on its way to its file, row by row.
#pragma once
#include <filesystem>
#include <memory>

#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/report/attributes.hpp"

namespace mariotte::report {

/// Rows go to the disk as they come, under the name `part_name` until `commit`. What a killed run had written
/// stays there; so does what is left on purpose. A file that ends otherwise is removed. All throw FileError.
class TraceFile {
 public:
  virtual ~TraceFile() = default;
  virtual void add(const impact::Sample& sample) = 0;
  virtual void commit() = 0;
  /// Keep the rows so far, and return the name of the file they are in.
  virtual std::filesystem::path leave() = 0;
};

/// Samples of these balls and contacts (from 0) into `path`: HDF5 if its name ends in .h5 or .hdf5, else the
/// CSV of `trace_csv`, beside which stands its `trace_metadata`. HDF5 files hold the tables `time` [s] (one
/// value per sample), `velocity` [m/s] (one row per sample, one column per ball), `gap` [m] and `force` [N]
/// (one column per contact), and the numbers of the columns, from 1, as `ball` and `contact`. These three and
/// `time` are the axes of the tables; tables have attributes `units` and `long_name`, and the file those of
/// `origin`. Throws FileError.
std::unique_ptr<TraceFile> new_trace_file(const std::filesystem::path& path, const std::vector<Index>& balls,
                                          const std::vector<Index>& contacts, const Attributes& origin = {});

/// The HDF5 half of it; throws FileError where the program was built without HDF5.
std::unique_ptr<TraceFile> new_hdf5_trace(const std::filesystem::path& path, const std::vector<Index>& balls,
                                          const std::vector<Index>& contacts, const Attributes& origin = {});

/// A whole table, CSV with units in its head, as HDF5: a table for each column, of its name, with attribute
/// `units`; the first one is the axis of all. Throws FileError as above.
void write_hdf5_columns(const std::filesystem::path& path, const std::string& csv, const Attributes& origin);

}  // namespace mariotte::report
