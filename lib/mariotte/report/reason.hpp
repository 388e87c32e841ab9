// Why a run stopped, as a sentence for the user.
#pragma once
#include <string>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"

namespace mariotte::report {

/// The message of a run or, if it has none, the limit of `options` that was reached; empty if it came to an
/// end.
std::string reason(hybrid::Ending ending, const std::string& message, const hybrid::Options& options);

}  // namespace mariotte::report
