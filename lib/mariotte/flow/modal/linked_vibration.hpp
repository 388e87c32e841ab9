// The vibration of contacts that link the dofs of a system in any way.
#pragma once
#include "mariotte/flow/linked_phase.hpp"
#include "mariotte/flow/modal/vibration.hpp"

namespace mariotte::flow {

/// An group is a connected component of closed contacts: each moves another of them. Shapes that move
/// nothing keep their stress: redundant contacts, or contacts between walls, which may come closer.
class LinkedVibration final : public Vibration {
 public:
  /// Finds the modes of a phase that must outlive them; false unless the ratio c/k is the same in all
  /// contacts of an group.
  bool find(const LinkedPhase& phase);
  void add_impulse(Index contact, double impulse, State x) const override;

 private:
  double approach(Index contact, ConstState x) const override;
  void start_group(const VibrationGroup& group) override;
  void add_pushes(Index open_contact) override;
  void find_groups();
  NaturalModes& shapes_of(const VibrationGroup& group) { return shapes_[&group - groups_.data()]; }
  void take_straight_parts(const VibrationGroup& group);

  const LinkedPhase* phase_ = nullptr;
  std::vector<NaturalModes> shapes_;  ///< by group
};

}  // namespace mariotte::flow
