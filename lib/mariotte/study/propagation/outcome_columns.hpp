// Where outcomes that have slopes stand in a result.
#pragma once
#include <optional>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/study/sweep/columns.hpp"

namespace mariotte::study {

/// One column per outcome of a scene of balls, for many runs side by side; empty if one has none.
std::optional<std::vector<Column>> columns_of(const std::vector<impact::OutcomeSlopes>& outcomes);

}  // namespace mariotte::study
