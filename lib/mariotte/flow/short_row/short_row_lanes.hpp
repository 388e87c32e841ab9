// Short rows side by side: one scene in each lane of a register.
#pragma once
#include <iterator>
#include <memory>
#include <span>

#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/flow/short_row/short_row.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"

namespace mariotte::flow {

/// What a row becomes does not depend on those beside it: a lane knows nothing of the others.
class ShortRowLanes {
 public:
  virtual ~ShortRowLanes() = default;
  /// Rows that push, until they are over or leave. A lane whose row has come to that takes the next one.
  virtual void follow(std::span<ShortRow* const> rows, const taylor::Precision& precision) = 0;
};

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
