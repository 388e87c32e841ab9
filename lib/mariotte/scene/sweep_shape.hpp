// `[[sweep]]` and `columns`: checked here, so that a scene is right or wrong whatever is done with it;
// carried out elsewhere.
#pragma once
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// The largest count, and number of values of one table.
inline constexpr Index most_points = 1'000'000'000;

/// Rejects a list whose tables are not `key` or `variable` with values, or from and to with count or step,
/// and not `key` with an expression.
void expect_sweeps(const Source& source, const Field& list);

/// Rejects what is not an array of at least one string.
void expect_columns(const Source& source, const Field& columns);

}  // namespace mariotte::scene
