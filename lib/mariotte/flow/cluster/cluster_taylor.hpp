// Series of phases of balls in which several contacts are closed, by fields that are compiled.
#pragma once
#include <memory>

#include "mariotte/flow/cluster/cluster_phase.hpp"
#include "mariotte/flow/flow.hpp"

namespace mariotte::flow {

/// Follows such a phase. Outcome `stiff` where no series goes on: whoever knows others does.
class ClusterTaylor {
 public:
  ClusterTaylor();
  ~ClusterTaylor();
  /// On from where another expansion has come `so_far`.
  Arrival follow(const Problem& problem, ClusterPhase& phase, State x, const Request& request,
                 std::vector<Index>& fired, const Arrival& so_far);

 private:
  class Expansion;
  std::unique_ptr<Expansion> expansion_;
};

}  // namespace mariotte::flow
