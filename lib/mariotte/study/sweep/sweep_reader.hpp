// A scene file to all that a sweep has to know.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/columns.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::study {

struct SweepPlan {
  scene::Document document;  ///< at the values of the first point
  Design design;
  std::vector<Column> columns;  ///< written out
  std::string title;
  std::vector<std::string> warnings;  ///< of the first point's scene, or the last one's
};

/// `columns` go before those of the scene. Throws SceneError, and ColumnError for a wrong key in `columns`.
SweepPlan read_sweep(scene::Document document, const std::vector<std::string>& columns = {});

}  // namespace mariotte::study
