// What an estimate says of the velocities of a result that are less exact than was asked.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace mariotte::impact {

/// "velocities may be wrong by 6.4e+00 of the largest speed, where 1e-10 was asked", or that nothing tells
/// how wrong, by an estimate that is infinite; empty where there is none, or it is within what was asked.
std::string doubt(std::optional<double> estimated, double asked);

/// Whether a text has such a sentence.
bool tells_doubt(std::string_view text);

}  // namespace mariotte::impact
