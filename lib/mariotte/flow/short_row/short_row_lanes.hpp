// Short rows side by side.
#pragma once
#include <iterator>
#include <memory>
#include <span>

#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/flow/lanes/scene_lanes.hpp"
#include "mariotte/flow/short_row/short_row.hpp"

namespace mariotte::flow {

using ShortRowLanes = SceneLanes<ShortRow>;

/// For rows with at most so many contacts.
MARIOTTE_PER_WIDE_INSTRUCTION_SET(std::unique_ptr<ShortRowLanes>, make_short_row_lanes, (int contacts),
                                  (contacts))

/// The whole course of many short rows, whose stage says at the end whether it is over.
class ShortRows {
 public:
  static constexpr std::size_t at_once = 256;  ///< so many hardly leave a lane idle, and fit into the caches

  /// At most `at_once` of them, which have begun.
  void follow(std::span<ShortRow> rows, double accuracy);

 private:
  static constexpr int sizes[] = {4, 6, ShortRow::most};  ///< contacts for which series are compiled

  std::unique_ptr<ShortRowLanes> lanes_[std::size(sizes)];
  ShortRow* selected_[at_once];
};

}  // namespace mariotte::flow
