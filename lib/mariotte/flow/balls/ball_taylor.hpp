// Series of phases in which one contact of balls is closed, by fields that are compiled.
#pragma once
#include <memory>

#include "mariotte/flow/balls/ball_phase.hpp"
#include "mariotte/flow/flow.hpp"

namespace mariotte::flow {

/// Follows such a phase. Outcome `stiff` where another contact may close: whoever knows all of them goes on.
class BallTaylor {
 public:
  BallTaylor();
  ~BallTaylor();
  Arrival follow(const Problem& problem, BallPhase& phase, State x, const Request& request,
                 std::vector<Index>& fired);

 private:
  class Expansion;
  std::unique_ptr<Expansion> expansion_;
};

}  // namespace mariotte::flow
