// Why a run stopped, as a sentence for the user.
#pragma once
#include <string>

#include "mariotte/impact/chain_impact.hpp"

namespace mariotte::report {

/// The message of the run or, if it has none, the limit of `options` that was reached; empty if it separated.
std::string reason(const impact::ChainImpact& impact, const hybrid::Options& options);

}  // namespace mariotte::report
