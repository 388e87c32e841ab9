// What the flows of rigid bodies are told: numbers and places in the state, nothing of laws and models.
#pragma once
#include <array>
#include <optional>

#include "mariotte/core/types.hpp"
#include "mariotte/core/vector3.hpp"

namespace mariotte::flow {

/// Places of a body's quantities in the state; −1 for what does not exist.
struct BodyPlaces {
  std::array<Index, 2> gap = {-1, -1};  ///< n of each tip
  Index position = -1;                  ///< tangential position of the mass centre, 2 values
  Index velocity = -1;                  ///< of the mass centre, 3 values
  Index attitude = -1;                  ///< quaternion w x y z, 4 values
  Index momentum = -1;                  ///< angular momentum, space axes, 3 values
  Index work = -1;  ///< dissipated by Hertz damping, adhesion damping and friction, 3 values
};

/// A body with equal moments about all axes normal to its own, with tips on that axis.
struct SymmetricBody {
  double mass;
  double axial, transverse;      ///< moments of inertia
  std::array<double, 2> arm;     ///< tip centre = arm × axis, from the mass centre
  std::array<double, 2> radius;  ///< of the tips
  double gravity;                ///< along −e1
};

/// One tip in contact with the plane, nothing else: F = s (k s² (1 − c_H ṅ) − b (1 + c_A ṅ)) with s = √δ.
struct TipPhase {
  /// What can move: only along the normal; in the plane of e1 and `tangent`, turning about `axis`; anyhow.
  enum class Motion { normal, planar, spatial };
  /// How the slip of a sliding tip starts: u ≠ 0; u = 0 and u̇ ≠ 0; both zero, at the edge of the cone.
  enum class Slip { moving, turning, breaking };

  BodyPlaces place;
  SymmetricBody body;
  Motion motion = Motion::normal;
  Vector3 tangent, axis;  ///< of planar motion; tangent = e1 × axis

  Index tip = 0;
  double stiffness, adhesion, damping_hertz, damping_adhesion;
  double friction = 0;    ///< μ
  double force_sign = 1;  ///< of F between two of its zeros
  bool sticking = false;
  Slip slip = Slip::moving;
  double direction = 1;    ///< of planar sliding: the sign of u along `tangent`
  Vector3 from_rest;       ///< of spatial sliding that starts at u = 0: where to
  bool indented = false;   ///< the lever of friction is r − δ instead of r
  double speed = 1;        ///< what errors of velocities are relative to
  double rest_speed = 0;   ///< a tip that moves no faster along the normal may have come to rest
  double held_weight = 0;  ///< of a body that cannot swing: it is held by that, too
  double slip_noise = 0;   ///< spatial slip below it is none
  double force_scale = 1;  ///< natural size of forces
  double force_noise = 0;  ///< sticking that needs less friction needs none
  double force_doubt = 0;  ///< relative error within which the sign of F does not change
  /// Guards by place, −1 where not watched.
  Index separation = -1, force = -1, stop = -1, cone = -1, turn_back = -1, other_tip = -1, rest = -1;
};

/// No tip touches; gravity alone acts.
struct FreePhase {
  BodyPlaces place;
  SymmetricBody body;
  std::array<Index, 2> guard = {-1, -1};  ///< of each tip's gap
};

}  // namespace mariotte::flow
