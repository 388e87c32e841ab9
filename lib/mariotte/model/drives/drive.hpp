// Bodies that move as a function of time says, or on which a force acts that is one.
#pragma once
#include <vector>

#include "mariotte/core/contact_direction.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/model/drives/signal.hpp"

namespace mariotte::model {

/// What a drive prescribes.
enum class Driven : unsigned char { position, velocity, force };

/// The velocities `direction` · v(t) are those of walls, with v the signal or, of a position, its rate; or
/// the force w F(t) acts along w = `direction`. Of a chain, w is +1 in one ball.
struct Drive {
  ContactDirection direction;
  Driven quantity = Driven::velocity;
  Signal signal;              ///< [m], [m/s] or [N]
  double until = infinity;    ///< of its signal only what is before counts [s]
  double reached = infinity;  ///< no larger speed comes of it, as far as is known [m/s]
};

/// The velocity that a drive prescribes at the start [m/s]; 0 of a force.
double start_velocity(const Drive& drive);
/// The force at the start [N]; 0 of a motion.
double start_force(const Drive& drive);
/// About the largest speed of what is driven, by a prescribed motion or by a force on what has an inverse
/// mass [1/kg] along it and nothing that holds it, unless less is known to be `reached` [m/s].
double driven_speed(const Drive& drive, double inverse_mass);
/// True if a drive prescribes this velocity.
bool prescribes(const std::vector<Drive>& drives, Index dof);

/// Throws InvalidParameter, naming the drive (from 1), unless signals are finite and in order, directions
/// have terms among `velocity`, no velocity is prescribed twice, and each that is belongs to a wall and
/// begins with the velocity that it has. `is_wall(dof)` says which are walls; a force must not act on any.
template <class IsWall>
void validate_drives(const std::vector<Drive>& drives, const std::vector<double>& velocity, IsWall&& is_wall);
/// Throws InvalidParameter if there is a drive and no `max_time` [s].
void expect_end(const std::vector<Drive>& drives, double max_time);

/// A drive in units of order one.
struct ScaledDrive {
  bool is_force;
  ContactDirection direction;  ///< w
  ContactDirection response;   ///< M⁻¹ w of a force, else w
  Signal signal;               ///< velocity or force
  Signal change;               ///< by which the velocities in `response` change: acceleration or force
};
/// True if one of the drives prescribes this velocity.
bool prescribes(const std::vector<ScaledDrive>& drives, Index dof);
/// Of a drive whose push is `response` per unit of force [1/kg].
ScaledDrive in_units(const Drive& drive, ContactDirection response, const Scale& scale);

/// Checks one drive but for its walls.
void validate_drive(const std::vector<Drive>& drives, std::size_t k, const std::vector<double>& velocity);
/// Throws InvalidParameter of drive k (from 0).
[[noreturn]] void reject_drive(std::size_t k, const char* rule);

template <class IsWall>
void validate_drives(const std::vector<Drive>& drives, const std::vector<double>& velocity,
                     IsWall&& is_wall) {
  for (std::size_t k = 0; k < drives.size(); ++k) {
    validate_drive(drives, k, velocity);
    for (const auto& [dof, coefficient] : drives[k].direction) {
      if (drives[k].quantity == Driven::force && is_wall(dof)) reject_drive(k, "a force moves no wall");
      if (drives[k].quantity != Driven::force && !is_wall(dof))
        reject_drive(k, "what moves as prescribed must be a wall (of infinite mass)");
    }
  }
}

}  // namespace mariotte::model
