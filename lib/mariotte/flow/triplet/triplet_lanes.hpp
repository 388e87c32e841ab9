// Triplets side by side: one scene in each lane of a register.
#pragma once
#include <memory>
#include <span>
#include <utility>

#include "mariotte/flow/instruction_set.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"
#include "mariotte/flow/triplet/triplet.hpp"

namespace mariotte::flow {

/// What a triplet becomes does not depend on those beside it: a lane knows nothing of the others.
class TripletLanes {
 public:
  virtual ~TripletLanes() = default;
  /// The first step of triplets that are all struck, or all pressed.
  virtual void start(std::span<Triplet* const> triplets, const taylor::Precision& precision) = 0;
  /// Triplets of which one contact pushes alone, until it lets go.
  virtual void end_pairs(std::span<Triplet* const> triplets) = 0;
  /// Triplets whose contacts are both closed, until one of them lets go. A lane whose triplet has come to
  /// that takes the next one.
  virtual void follow(std::span<Triplet* const> triplets, const taylor::Precision& precision) = 0;
};

/// What the lanes of a register hold: many scenes side by side, or the contacts of one.
enum class Lanewise { scenes, contacts };

MARIOTTE_PER_INSTRUCTION_SET(std::unique_ptr<TripletLanes>, make_triplet_lanes,
                             (Lanewise lanewise = Lanewise::scenes), (lanewise))

/// The whole course of many triplets, whose stage says at the end whether it is over.
class Triplets {
 public:
  static constexpr std::size_t at_once = 256;  ///< so many hardly leave a lane idle, and fit into the caches

  explicit Triplets(std::unique_ptr<TripletLanes> lanes = make_triplet_lanes()) : lanes_(std::move(lanes)) {}
  /// At most `at_once` of them, which have begun.
  void follow(std::span<Triplet> triplets, double accuracy);

 private:
  bool advance(std::span<Triplet> triplets, TripletStage stage, const taylor::Precision& precision);

  std::unique_ptr<TripletLanes> lanes_;
  Triplet* selected_[at_once];
};

}  // namespace mariotte::flow
