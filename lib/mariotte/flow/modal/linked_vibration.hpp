// The vibration of contacts that link the freedoms of a system in any way.
#pragma once
#include "mariotte/flow/linked_phase.hpp"
#include "mariotte/flow/modal/vibration.hpp"

namespace mariotte::flow {

/// All closed contacts are one island. Shapes that move nothing keep their stress: redundant contacts, or
/// contacts between walls, which may come closer.
class LinkedVibration final : public Vibration {
 public:
  /// Finds the modes of a phase that must outlive them; false unless the ratio c/k is the same in all closed
  /// contacts.
  bool find(const LinkedPhase& phase);
  void push(Index contact, double impulse, State x) const override;

 private:
  double approach(Index contact, ConstState x) const override;
  void start_island(const Island& island) override;
  void add_pushes(Index open_contact) override;
  void take_straight_parts(const Island& island);

  const LinkedPhase* phase_ = nullptr;
  NaturalModes shapes_;
};

}  // namespace mariotte::flow
