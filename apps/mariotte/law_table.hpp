// A table of impulse ratios, looked up for what collides.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/laws/icr_table.hpp"

namespace mariotte::command {

/// Balls from left to right.
struct Balls {
  std::vector<double> mass, velocity;
};

/// The answer of the table in `file` for these balls, which say the axes of masses and velocities; `at`,
/// NAME=VALUE each, says others that have more than one value. Throws UsageError, scene::FileError,
/// scene::SceneError for what is no table, and impact::OutsideTable.
impact::TableAnswer look_up(const std::string& file, const std::vector<std::string>& at, const Balls& balls);

}  // namespace mariotte::command
