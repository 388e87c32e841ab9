// The vibration of contacts that link the freedoms of a system in any way.
#pragma once
#include "mariotte/flow/linked_phase.hpp"
#include "mariotte/flow/modal/vibration.hpp"

namespace mariotte::flow {

/// An island is a connected component of closed contacts: each moves another of them. Shapes that move
/// nothing keep their stress: redundant contacts, or contacts between walls, which may come closer.
class LinkedVibration final : public Vibration {
 public:
  /// Finds the modes of a phase that must outlive them; false unless the ratio c/k is the same in all
  /// contacts of an island.
  bool find(const LinkedPhase& phase);
  void push(Index contact, double impulse, State x) const override;

 private:
  double approach(Index contact, ConstState x) const override;
  void start_island(const Island& island) override;
  void add_pushes(Index open_contact) override;
  void find_islands();
  NaturalModes& shapes_of(const Island& island) { return shapes_[&island - islands_.data()]; }
  void take_straight_parts(const Island& island);

  const LinkedPhase* phase_ = nullptr;
  std::vector<NaturalModes> shapes_;  ///< by island
};

}  // namespace mariotte::flow
