// What a sweep leaves in its folder.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "mariotte/report/json/column_statistics.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/study/journal/journal.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"

namespace mariotte::command {

/// Where the files go, and which of them.
struct SweepFiles {
  std::filesystem::path folder;
  bool hdf5 = false;
  bool no_figures = false;
  bool report = false;
};

/// Make the folder, and with `force` empty it of an earlier sweep; else throw report::FileError if it holds a
/// result whose journal is gone, or if a file cannot be written.
void prepare(const SweepFiles& files, const study::SweepPlan& plan, bool force);

/// What came of it.
struct Written {
  std::optional<report::ColumnStatistics> statistics = {};  ///< of a random design
  Index limited = 0;                                        ///< points that ended at a limit
  Index doubtful = 0;                                       ///< points less exact than was asked
  std::string shortfall = {};                               ///< which figures are missing and why, if any are
};

/// Write the files of a complete journal, and `what` the sweep was into sweep.json. Throws report::FileError.
Written write(const SweepFiles& files, const study::SweepPlan& plan, const report::Json& what,
              study::Journal& journal);

}  // namespace mariotte::command
