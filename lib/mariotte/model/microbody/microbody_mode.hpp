// The discrete state of a microbody: how each tip touches the plane.
//
//   from      guard that fires                    to
//   clear     n falls through 0                   sliding; sticking if u = 0 and friction can hold
//   sliding   n rises through 0                   clear
//   sliding   F_n = 0                             sliding, friction on the other sign of F_n
//   sliding   u = 0, needed friction ≤ μ |F_n|    sticking
//   sliding   u = 0, needed friction > μ |F_n|    sliding, along u̇ as it is without friction
//   sticking  n rises through 0                   clear
//   sticking  F_n = 0                             sticking; seen only if sticking needs no friction at all
//   sticking  needed friction reaches μ |F_n|     sliding, against the needed friction
//   closed    ṅ falls through 0 with δ > 0        captured, once
//   closed    all closed tips rest in their wells captured
//   all clear mass centre rises over its reach    escaped; of bodies whose flight has no closed form
//
// Needed friction is what keeps u̇ = 0. The cone closes at F_n = 0, so sticking that needs friction breaks
// into slip shortly before, and may stick again shortly after; such episodes can be as short as rounding. In
// a plane u = 0 is a zero of u; in space it is a slip that has turned back against its direction, or sunk
// into noise.
#pragma once
#include <array>

#include "mariotte/core/types.hpp"
#include "mariotte/core/vector3.hpp"

namespace mariotte::model {

/// How a tip touches the plane; the table at the top says what leads from one to the next.
enum class TipContact : unsigned char { clear, sliding, sticking };

/// How the slip of a sliding tip starts: it goes on; from u = 0; from u = 0 with u̇ = 0, at the edge of the
/// cone.
enum class SlipStart : unsigned char { moving, turning, breaking };

/// All that is discrete about one tip.
struct TipMode {
  TipContact contact = TipContact::clear;
  double force_sign = 1;  ///< of F_n, −1 while adhesion prevails
  SlipStart start = SlipStart::moving;
  bool at_touch = false;   ///< of a slip from rest: it began when the tip touched, where all forces are zero
  Vector3 direction = {};  ///< of the slip when sliding began or went on; unit vector in the plane
  double rest = 0;         ///< slip along `direction` that counts as rest where a slip from rest began
};

/// All that is discrete about a body.
struct MicrobodyMode {
  std::array<TipMode, 2> tip;
  Index impacts = 0;      ///< contacts that have ended
  bool captured = false;  ///< a tip has turned back in the well
  bool escaped = false;   ///< too high for any tip to touch, and rising
};

/// What can happen to a tip at an event.
enum class TipEvent : unsigned char { open, close, stick, slip, force_positive, force_negative, capture };

/// What has happened to which tip.
struct MicrobodyChange {
  Index tip;
  TipEvent event;
  double speed = 0;  ///< of the tip along the normal where it closes or opens, ≥ 0
};

}  // namespace mariotte::model
