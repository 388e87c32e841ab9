// Sets of points as ranges of neighbours.
#pragma once
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::study {

/// Points first … first + count − 1.
struct PointRange {
  Index first = 0;
  Index count = 0;
};

/// What `done` leaves of 0 … points − 1, in order. Overlaps do no harm.
std::vector<PointRange> missing(std::vector<PointRange> done, Index points);

/// Number of points in all.
Index total(const std::vector<PointRange>& ranges);

/// Deals points out to the workers of one process, in order. Of several processes each gets its share of
/// small pieces, like cards.
class Dealer {
 public:
  struct Part {
    Index rank = 0;
    Index ranks = 1;
  };
  Dealer(std::vector<PointRange> points, Part part);

  /// The next at most `most` points; none if all are dealt.
  PointRange take(Index most);

 private:
  std::vector<PointRange> pieces_;  ///< of this process, the last to be dealt first
};

}  // namespace mariotte::study
