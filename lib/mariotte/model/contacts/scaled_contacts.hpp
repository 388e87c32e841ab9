// The contacts of a chain or a network in units of order one, with the natural sizes that tolerances are
// relative to.
#pragma once
#include <algorithm>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/model/drives/drive.hpp"

namespace mariotte::model {

/// Contact j alone, struck at the reference speed, would indent by about length[j] within about time[j]
/// [Acary 2003, §2.2]: L = (m* v²/k)^{1/(n+1)}, T = L/v with m* the reduced mass.
struct ScaledContacts {
  Scale scale;
  std::vector<contact::Law> law;      ///< one per contact, as all that is not said to be of velocities
  std::vector<double> gap, velocity;  ///< at the start
  double speed = 1;                   ///< reference speed: largest that can matter
  double reached_speed = 1;           ///< of it what dampers do not hold back
  std::vector<double> reduced_mass;   ///< 1/(G M⁻¹ Gᵀ)_jj
  std::vector<double> length, time;   ///< natural ones of each contact alone
  double noise_speed = 0;             ///< approach speed that cannot be told from rest
  std::vector<double> noise_depth;    ///< depth that a contact approached so slowly reaches
  double fade_speed_ratio = 1;        ///< speed at which a contact fades, relative to noise_speed
  double fade_depth_ratio = 1;        ///< depth at which it does, relative to noise_depth
  std::vector<ScaledDrive> drive;     ///< their directions and responses name velocities by number

  Index contacts() const { return std::ssize(law); }
  /// Half of this depth is where a contact that moves slowly fades, and twice takes it out of the noise.
  double fading_depth(Index j) const { return fade_depth_ratio * noise_depth[j]; }
};

/// Contacts and velocities as a user states them.
struct StatedContacts {
  const std::vector<contact::Law>& law;
  const std::vector<double>& gap;
  const std::vector<double>& velocity;
};

/// Squares of the speed that a scene gives, by velocities and gravity; of the one that drives do, and those
/// less the forces that they start with; of the one that indentations give back, as much of that as their
/// dampers let through, and as forces give at once that do not balance; and of the speed that adhesion gives
/// to what meets.
struct SquaredSpeeds {
  double given = 0, driven = 0, driven_changes = 0;
  double released = 0, let_through = 0, unbalanced = infinity, adhesion = 0;

  double before() const { return given + driven + released; }
  double all() const { return before() + adhesion; }
  double reached() const { return given + driven + let_through + adhesion; }
  /// Share of an accuracy that phases may spend.
  double refinement() const { return in_wells() * in_balance(); }
  /// An error of the large speed V in a well is one of V/v of the small speed v behind it, and the accuracy
  /// is meant relative to v, not V.
  double in_wells() const { return before() > 0 ? std::max(before() / all(), 1e-4) : 1; }
  /// What is pressed and in balance vibrates with what moves it, not with what its indentations hold back; a
  /// billionth of that at least.
  double in_balance() const;
  /// Share of the largest speed that the accuracy of velocities is relative to: that of the vibration, but
  /// where nothing moves, and velocities are rounding, there is none.
  double accurate_share() const;
  /// A drive on what has this inverse mass along it.
  void drive(const Drive& drive, double inverse_mass);
  /// What a contact indented at the start gives to a reduced mass: its energy, unless its damper takes all of
  /// its force before.
  void release(const contact::Law& law, double indentation, double mass);
};

/// The speed at which bodies meet, of the largest speed in a scene; the latter if none do. No less than what
/// rounding of the largest leaves ten digits of.
inline double of_what_meets(double meeting, double largest) {
  constexpr double least_share = 1e-5;
  return meeting > 0 ? std::clamp(meeting, least_share * largest, largest) : largest;
}

/// The largest relative speed of a scene, by velocities, gravity, drives and stored energy, and the one that
/// its accuracy is relative to: of what is pressed and in balance that of its vibration, if it has any [m/s].
struct Speeds {
  double largest, reference;
};

/// Convert into `d`, whose memory is reused and whose `reduced_mass` says those in the scene's units. The
/// contact with the shortest natural time at the reference speed sets the units: it alone, so that a
/// mirrored chain has the same. `accuracy` decides what is slow: a tenth of what may be wrong anyway.
void scale_contacts(const StatedContacts& stated, double speed, double accuracy, ScaledContacts& d);

/// What follows from the speeds of a scene once its contacts are in units.
void take_speeds(const SquaredSpeeds& speeds, ScaledContacts& d);

/// The same contacts with other numbers, in the units that `d` already has; natural sizes stay as they are.
void restate_contacts(const StatedContacts& stated, ScaledContacts& d);

/// Approach that counts as none, relative to the largest: a tenth of the accuracy, but what double precision
/// can tell.
double noise_share(double accuracy);

/// Damping group (∂f/∂δ̇) T/m* of contact j at its natural indentation, c δⁿ⁻¹ T/m* of a power law: what makes
/// it stiff.
double damping_group(const ScaledContacts& scaled, Index j);

}  // namespace mariotte::model
