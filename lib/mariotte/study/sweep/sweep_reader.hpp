// A scene file to all that a sweep has to know.
#pragma once
#include <string>
#include <vector>

#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/design.hpp"
#include "mariotte/study/sweep/evaluate.hpp"

namespace mariotte::study {

struct SweepPlan {
  scene::Document document;  ///< at the values of the first point
  Design design;
  std::vector<std::string> columns;  ///< result keys, written out
  std::string title;
  std::vector<std::string> warnings;  ///< of the first point's scene, or the last one's
};

/// `columns` go before those of the scene. Simulates one point, to see which columns there are. Throws
/// SceneError, and ColumnError for a wrong key in `columns`.
SweepPlan read_sweep(scene::Document document, const Simulate& simulate,
                     const std::vector<std::string>& columns = {});

}  // namespace mariotte::study
