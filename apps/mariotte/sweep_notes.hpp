// What a sweep says on stderr beside its progress.
#pragma once
#include <chrono>
#include <filesystem>

#include "mariotte/study/journal/journal.hpp"
#include "mariotte/study/sweep/sweep.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"

namespace mariotte::command {

/// What a point costs in processor time, and what of it is not the simulation.
void tell_cost(const study::Progress& progress, int threads, std::chrono::duration<double> taken);

/// How many points an earlier run has done, if any.
void tell_resumed(const study::SweepPlan& plan, const study::Journal& journal);

/// What is kept of a sweep that was stopped.
void tell_interrupted(const std::filesystem::path& folder, const study::SweepPlan& plan,
                      const study::Journal& journal);

}  // namespace mariotte::command
