// The vibration of bodies in a row.
#pragma once
#include "mariotte/flow/modal/damped_modes.hpp"
#include "mariotte/flow/modal/vibration.hpp"
#include "mariotte/flow/serial_phase.hpp"

namespace mariotte::flow {

/// An group is a row of closed contacts with no wall inside. Its total indentation moves straight in time
/// between two walls.
class RowVibration final : public Vibration {
 public:
  /// Finds the modes of a phase that must outlive them. Contacts of different ratios c/k have complex shapes;
  /// false if these are too close to each other to tell what takes part in a motion.
  bool find(const SerialPhase& phase);
  void add_impulse(Index contact, double impulse, State x) const override;

 private:
  double approach(Index contact, ConstState x) const override;
  void start_group(const VibrationGroup& group) override;
  void add_pushes(Index open_contact) override;

  void find_groups();
  void gather_row(const VibrationGroup& group);
  DampedRow row() const { return {inverse_mass_, stiffness_, damping_}; }
  bool add_damped_modes(const VibrationGroup& group);
  void take_straight_part(const VibrationGroup& group);
  void ride_damped_modes(const VibrationGroup& group, const DampedModes& shapes);

  const SerialPhase* phase_ = nullptr;
  std::vector<NaturalModes> natural_;  ///< by group, as far as it is proportional
  std::vector<DampedModes> damped_;    ///< by group, as far as it is not
  std::vector<double> inverse_mass_;   ///< of the bodies of the group at hand
};

}  // namespace mariotte::flow
