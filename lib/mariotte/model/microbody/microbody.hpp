// A microbody about to strike a plane: the parameters a user states, in SI (or any consistent) units
// [Cheng 2002].
#pragma once
#include <optional>
#include <vector>

#include "mariotte/contact/brach_dunn.hpp"
#include "mariotte/contact/coulomb.hpp"
#include "mariotte/core/quaternion.hpp"
#include "mariotte/model/microbody/rigid_body.hpp"

namespace mariotte::model {

/// Where friction acts: at r e1 below the tip's centre, as in the paper, or at the plane itself, r − δ below.
enum class Lever { radius, indented };

/// When a tip that has turned back in the well ends the run, or not at all.
enum class AfterCapture { stop, go_on };

/// The plane is at height 0 with normal e1; the body starts with its first tip touching it.
struct Microbody {
  RigidBody body;
  std::vector<contact::BrachDunn> law;  ///< one per tip
  contact::Coulomb friction;
  Quaternion attitude;
  Vector3 velocity;    ///< of the mass centre [m/s]; e1 < 0 goes towards the plane
  Vector3 spin;        ///< space axes [rad/s]
  double gravity = 0;  ///< along −e1 [m/s²]
  Lever lever = Lever::radius;
  Index impacts = 1;  ///< stop after so many; for 1 the other tip is left out, as in the paper
  AfterCapture after_capture = AfterCapture::stop;
};

/// Height of the mass centre when the first tip just touches [m].
double start_height(const Microbody& body);

/// Normal velocity of the centre of tip i at the start [m/s].
double tip_velocity(const Microbody& body, std::size_t tip);

/// A tip other than the first that would start below the plane, if any; from 0.
std::optional<std::size_t> tip_below_plane(const Microbody& body);

/// Throws InvalidParameter unless body, laws and motion make sense: the first tip approaches, and no other
/// tip starts below the plane.
void validate(const Microbody& body);

}  // namespace mariotte::model
