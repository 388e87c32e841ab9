// The vibration of bodies in a row.
#pragma once
#include "mariotte/flow/modal/damped_modes.hpp"
#include "mariotte/flow/modal/vibration.hpp"
#include "mariotte/flow/serial_phase.hpp"

namespace mariotte::flow {

/// An island is a row of closed contacts with no wall inside. Its total indentation moves straight in time
/// between two walls.
class RowVibration final : public Vibration {
 public:
  /// Finds the modes of a phase that must outlive them. Contacts of different ratios c/k have complex shapes;
  /// false if these are too close to each other to tell what takes part in a motion.
  bool find(const SerialPhase& phase);
  void push(Index contact, double impulse, State x) const override;

 private:
  double approach(Index contact, ConstState x) const override;
  void start_island(const Island& island) override;
  void add_pushes(Index open_contact) override;

  void find_islands();
  void gather_row(const Island& island);
  DampedRow row() const { return {inverse_mass_, stiffness_, damping_}; }
  bool add_damped_modes(const Island& island);
  void take_straight_part(const Island& island);
  void ride_damped_modes(const Island& island, const DampedModes& shapes);

  const SerialPhase* phase_ = nullptr;
  std::vector<NaturalModes> natural_;  ///< by island, as far as it is proportional
  std::vector<DampedModes> damped_;    ///< by island, as far as it is not
  std::vector<double> inverse_mass_;   ///< of the bodies of the island at hand
};

}  // namespace mariotte::flow
