// The motion of linear contacts as waves: modes, and how each contact rides on them.
#pragma once
#include <span>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/modal/natural_modes.hpp"
#include "mariotte/flow/modal/wave.hpp"
#include "mariotte/flow/phase_contact.hpp"

namespace mariotte::flow {

/// Closed contacts that shake together.
struct VibrationGroup {
  Index first;     ///< place among the members of all groups
  Index count;     ///< contacts
  double ratio;    ///< c/k of all contacts, or < 0 if they differ
  Index straight;  ///< as many of its shapes do not vibrate: they move straight in time
  Index first_mode;

  Index modes() const { return count - straight; }
};

/// What a contact does: δ = −g, and where it is closed its force and its impulse since the start.
struct ContactMotion {
  Wave depth;
  Wave force;
  std::vector<Weight> impulse;  ///< of what the modes have changed since the start, beside ∫ force's line

  double impulse_at(const std::vector<Swing>& swing, double time) const;
};

/// What rows and networks of contacts have in common; reuses its memory from phase to phase. Equal ratios
/// c/k, none among them, have the shapes of the undamped contacts, and each mode decays as one body would, at
/// and beyond critical damping, too.
class Vibration {
 public:
  virtual ~Vibration() = default;
  /// The motion that starts from x, of the phase whose modes were found last.
  void start(ConstState x);
  /// How far the sum of modes that were found one by one misses x, relative to natural depths and to the
  /// rates it is made of: modes that are nearly alike may each be wrong by more than rounding.
  double misfit(ConstState x) const;
  /// What an impulse of a contact adds to the velocities.
  virtual void add_impulse(Index contact, double impulse, State x) const = 0;

  std::span<const PhaseContact> contacts() const { return contacts_; }
  const std::vector<NaturalMode>& modes() const { return modes_; }
  const std::vector<VibrationGroup>& groups() const { return groups_; }
  std::span<const Index> members(const VibrationGroup& group) const;
  const ContactMotion& of(Index contact) const { return motion_[contact]; }
  /// Least and largest |λ|.
  double slowest() const;
  double fastest() const;

 protected:
  /// δ̇ of a contact.
  virtual double approach(Index contact, ConstState x) const = 0;
  virtual void start_group(const VibrationGroup& group) = 0;
  virtual void add_pushes(Index open_contact) = 0;

  void begin(std::span<const PhaseContact> contacts);
  /// Stiffness and damping of the members; c/k of all of them, or −1.
  void gather(const VibrationGroup& group);
  double common_ratio() const;
  /// Shapes of zero frequency go last, and do not vibrate.
  void add_natural_modes(VibrationGroup& group, NaturalModes& shapes);
  void ride_natural_modes(const VibrationGroup& group, const NaturalModes& shapes);
  /// Adds factor · ∫∫ f dt dt of a closed contact to the depth of an open one.
  void add_push(Index open_contact, Index closed_contact, double factor);

  std::vector<NaturalMode> modes_;
  std::vector<VibrationGroup> groups_;
  std::vector<Index> members_;
  std::vector<ContactMotion> motion_;
  std::vector<double> stiffness_, damping_, depth_, rate_;  ///< by member of the group at hand

 private:
  void start_open(Index contact, ConstState x);

  std::span<const PhaseContact> contacts_;
};

}  // namespace mariotte::flow
