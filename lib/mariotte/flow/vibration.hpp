// The motion of linear contacts as waves: modes, and how each contact rides on them.
#pragma once
#include <span>
#include <vector>

#include "mariotte/flow/damped_modes.hpp"
#include "mariotte/flow/natural_modes.hpp"
#include "mariotte/flow/serial_phase.hpp"
#include "mariotte/flow/wave.hpp"

namespace mariotte::flow {

/// A row of closed contacts with no wall inside: it shakes by itself.
struct Island {
  Index first;         ///< contact
  Index count;         ///< contacts
  double ratio;        ///< c/k of all contacts, or < 0 if they differ
  bool between_walls;  ///< then its total indentation is straight in time
  Index first_mode;
};

/// What a contact does: δ = −g, and where it is closed its force and its impulse since the start.
struct ContactMotion {
  Wave depth;
  Wave force;
  std::vector<Weight> impulse;  ///< of what the modes have changed since the start, beside ∫ force's line

  double impulse_at(const std::vector<Swing>& swing, double time) const;
};

/// Reuses its memory from phase to phase.
class Vibration {
 public:
  /// Finds the modes. Equal ratios c/k, none among them, have the shapes of the undamped contacts, and each
  /// mode decays as one body would, at and beyond critical damping, too. Other damping has complex shapes;
  /// false if these are too close to each other to tell what takes part in a motion.
  bool find(const SerialPhase& phase);
  /// The motion that starts from x.
  void start(const SerialPhase& phase, ConstState x);

  const std::vector<Mode>& modes() const { return modes_; }
  const std::vector<Island>& islands() const { return islands_; }
  const ContactMotion& of(Index contact) const { return motion_[contact]; }
  /// Least and largest |λ|.
  double slowest() const;
  double fastest() const;

 private:
  void find_islands(const SerialPhase& phase);
  void gather(const SerialPhase& phase, const Island& island);
  DampedRow row() const { return {inverse_mass_, stiffness_, damping_}; }
  void add_natural_modes(const Island& island);
  bool add_damped_modes(const Island& island);
  void start_island(const SerialPhase& phase, const Island& island, ConstState x);
  void take_straight_part(const Island& island);
  void ride_natural_modes(const Island& island, const NaturalModes& shapes);
  void ride_damped_modes(const Island& island, const DampedModes& shapes);
  void start_open(const SerialPhase& phase, Index contact, ConstState x);
  void add_push(Wave& depth, const ContactMotion& neighbour, double inverse_mass) const;

  std::vector<Mode> modes_;
  std::vector<Island> islands_;
  std::vector<ContactMotion> motion_;
  std::vector<NaturalModes> natural_;  ///< by island, as far as it is proportional
  std::vector<DampedModes> damped_;    ///< by island, as far as it is not
  std::vector<double> inverse_mass_, stiffness_, damping_, depth_, rate_;
};

}  // namespace mariotte::flow
