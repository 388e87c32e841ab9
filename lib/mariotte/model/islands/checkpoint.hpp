// Where a run of islands is, so that another can go on from there.
#pragma once
#include <vector>

#include "mariotte/model/islands/free_balls.hpp"
#include "mariotte/model/islands/island.hpp"
#include "mariotte/model/islands/island_queue.hpp"

namespace mariotte::model {

/// Some fifty bytes a ball. The chain and the layout of the run must outlive it.
struct Checkpoint {
  Instant now;
  FreeBalls balls;
  std::vector<int> owner;           ///< of each ball
  std::vector<IslandStart> island;  ///< each as of its own time
  std::vector<Index> unused;        ///< among them
  IslandQueue queue;
  Index most_steps;

  std::size_t bytes() const;
};

}  // namespace mariotte::model
