#include "mariotte/flow/triplet/triplet_lanes.hpp"

#include <algorithm>

#include "mariotte/flow/lanes/lane_precision.hpp"

namespace mariotte::flow {

/// Those that are at this stage; false if there is none.
bool Triplets::advance(std::span<Triplet> triplets, TripletStage stage, const taylor::Precision& precision) {
  std::size_t count = 0;
  for (auto& one : triplets)
    if (one.stage == stage) selected_[count++] = &one;
  const std::span<Triplet* const> found(selected_, count);
  if (stage == TripletStage::flight) std::for_each(found.begin(), found.end(), fly);
  if (stage == TripletStage::alone) lanes_->end_pairs(found);
  if (stage == TripletStage::meets) std::for_each(found.begin(), found.end(), meet);
  if (stage == TripletStage::struck || stage == TripletStage::pressed) lanes_->start(found, precision);
  if (stage == TripletStage::both && count > 0) lanes_->follow(found, precision);
  return count > 0;
}

void Triplets::follow(std::span<Triplet> triplets, double accuracy) {
  const auto precision = lane_precision(accuracy, triplet_orders);
  using enum TripletStage;
  if (triplets.size() == 1) {
    const auto& stage = triplets.front().stage;  // so that no other one is looked for
    while (stage != over && stage != leaves) advance(triplets, stage, precision);
    return;
  }
  for (bool any = true; any;) {
    any = false;
    for (const auto stage : {struck, pressed, both, alone, meets, flight})
      if (advance(triplets, stage, precision)) any = true;
  }
}

}  // namespace mariotte::flow
