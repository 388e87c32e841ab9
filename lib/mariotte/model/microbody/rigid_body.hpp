// Rigid bodies that touch a plane with spherical tips.
#pragma once
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/core/vector3.hpp"

namespace mariotte::model {

/// A sphere fixed to the body, by which it touches the plane.
struct Tip {
  Vector3 centre;     ///< from the mass centre, body axes [m]
  double radius = 0;  ///< [m]
};

/// Body axes are principal, with e1 along the body.
struct RigidBody {
  double mass = 0;        ///< [kg]
  Vector3 inertia;        ///< principal moments [kg m²]
  std::vector<Tip> tips;  ///< one or two; the first has to be the first to touch
};

/// Solid sphere, m = (4/3) π r³ ρ.
RigidBody sphere(double radius, double density);

/// Two solid hemispheres on a massless rod, tips at ∓(L/2) e1 with L = length_ratio · r [Cheng 2002, fig. 5]:
/// I₁ = (2/5) m r², I₂ = I₃ = m [83/320 r² + (L/2 + 3r/8)²].
RigidBody dumbbell(double radius, double length_ratio, double density);

/// Cylinder of length L with hemispherical ends [Cheng 2002, fig. 6]: m_c = π r² L ρ beside the hemispheres.
RigidBody rod(double radius, double length_ratio, double density);

/// Of the tips, from the mass centre.
double reach(const RigidBody& body);

/// Equal moments about e2 and e3, and all tips on e1.
bool is_symmetric(const RigidBody& body);

/// Throws InvalidParameter unless mass and radii are positive, the moments are those of some body (each at
/// most the sum of the others), and there are one or two tips.
void validate(const RigidBody& body);

}  // namespace mariotte::model
