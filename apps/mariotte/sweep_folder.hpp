// What a sweep leaves in its folder.
#pragma once
#include <filesystem>
#include <string>

#include "mariotte/report/json.hpp"
#include "mariotte/study/journal.hpp"
#include "mariotte/study/sweep_reader.hpp"

namespace mariotte::command {

/// Make the folder, and with `force` empty it of an earlier sweep; else throw report::FileError if it holds a
/// result whose journal is gone.
void prepare_sweep_folder(const std::filesystem::path& folder, bool force);

/// See that the sweep can be written as HDF5 before it is computed. Throws report::FileError.
void check_hdf5(const std::filesystem::path& folder, const study::SweepPlan& plan);

/// Write sweep.csv, plot.csv and, if asked for, sweep.h5 from a complete journal, and `what` the sweep was
/// into sweep.json. Throws report::FileError.
void write_sweep(const std::filesystem::path& folder, const study::SweepPlan& plan, const report::Json& what,
                 study::Journal& journal, bool hdf5);

/// Write plot.gp and draw the figures. Returns an empty text, or which are missing and why. Throws
/// report::FileError.
std::string draw_sweep(const std::filesystem::path& folder, const study::SweepPlan& plan);

}  // namespace mariotte::command
