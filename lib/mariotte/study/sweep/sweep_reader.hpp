// A scene file to all that a sweep has to know.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/columns.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::study {

/// A column: a number of the result, or a formula.
struct Output {
  std::size_t result = 0;
  std::optional<Formula> formula = {};
};

struct SweepPlan {
  scene::Document document;  ///< at the values of the first point
  Design design;
  std::vector<Column> columns;  ///< written out
  std::vector<Column> results;  ///< what has to be known of each result
  std::vector<Output> outputs;  ///< how the columns follow from it
  std::string title;
  scene::Figure figure;
  std::vector<std::string> warnings;  ///< of the first point's scene, or the last one's
};

/// `columns` go before those of the scene. Throws SceneError, and ColumnError for a wrong key in `columns`.
/// A column is a key of a result, or "name = expression" of keys of the result and of the scene.
SweepPlan read_sweep(scene::Document document, const std::vector<std::string>& columns = {});

/// Refuse a column of a scene file that no point of its design could give, where it stands; runs nothing.
/// Throws SceneError.
void expect_own_columns(const scene::Document& document, const Design& design);

}  // namespace mariotte::study
