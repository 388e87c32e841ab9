// What a run says on stderr beside its result, and to the shell.
#pragma once
#include <string>
#include <vector>

#include "command_line/exit_code.hpp"
#include "mariotte/report/warnings.hpp"
#include "mariotte/scene/simulate.hpp"

namespace mariotte::command {

/// Why a run ended early, after `where`; returns its exit code. A time limit and an interruption are the
/// user's own wish, and only warned of.
ExitCode tell_ending(hybrid::Ending ending, const std::string& message, const scene::Scene& scene,
                     const std::string& where = "");

/// What has to be said of a run of any model.
std::vector<std::string> warnings(const scene::Impact& impact, const scene::Scene& scene);

/// Warnings of a run, each after `where`, unless quiet.
void tell_warnings(const std::vector<std::string>& warnings, bool quiet, const std::string& where = "");

/// Both; returns the exit code of the run.
ExitCode tell_run(const scene::Impact& impact, const scene::Scene& scene, bool quiet,
                  const std::string& where = "");

/// The same of a scene whose bodies strike at this speed [m/s].
ExitCode tell_run_at(double speed, const scene::Scene& scene, bool quiet);

}  // namespace mariotte::command
