// `[figure]`: how the figures of a scene shall look.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::scene {

/// How the figures of a scene look.
struct Figure {
  std::optional<std::array<double, 2>> window = {};  ///< from and to [s]; by default where forces can be seen
  std::vector<Index> balls = {}, contacts = {};      ///< that a run shows, from 1; empty: all
  bool logarithmic = false;                          ///< colours of images and maps
  Index contours = 0;                                ///< lines of equal value in maps of a sweep
};

}  // namespace mariotte::scene
