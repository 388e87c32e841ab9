// What a sweep leaves in its folder.
#pragma once
#include <filesystem>
#include <string>

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

/// Write the files of a complete journal, and `what` the sweep was into sweep.json. Returns an empty text, or
/// which figures are missing and why. Throws report::FileError.
std::string write(const SweepFiles& files, const study::SweepPlan& plan, const report::Json& what,
                  study::Journal& journal);

}  // namespace mariotte::command
