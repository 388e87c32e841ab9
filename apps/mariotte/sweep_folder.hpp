// What a sweep leaves in its folder.
#pragma once
#include <filesystem>
#include <string>

#include "mariotte/study/journal.hpp"
#include "mariotte/study/sweep_reader.hpp"

namespace mariotte::command {

/// Make the folder, and with `force` empty it of an earlier sweep; else throw report::FileError if it holds a
/// result whose journal is gone.
void prepare_sweep_folder(const std::filesystem::path& folder, bool force);

/// Write sweep.csv and plot.csv from a complete journal. Throws report::FileError.
void write_sweep(const std::filesystem::path& folder, const study::SweepPlan& plan, study::Journal& journal);

/// Write plot.gp and draw the figures. Returns an empty text, or which are missing and why. Throws
/// report::FileError.
std::string draw_sweep(const std::filesystem::path& folder, const study::SweepPlan& plan);

}  // namespace mariotte::command
