// The limit that stopped a run, as a sentence.
#pragma once
#include <string>
#include <string_view>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"

namespace mariotte::hybrid {

/// "max_time = 2 s was reached before the end", by the key that the scene has; empty at any other ending.
std::string reached_limit(Ending ending, const Options& options);

/// Whether a text has such a sentence.
bool tells_limit(std::string_view text);

}  // namespace mariotte::hybrid
