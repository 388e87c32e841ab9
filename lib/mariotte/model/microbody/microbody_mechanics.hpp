// Kinematics, contact forces and the equations of motion of a microbody: m v̇ = Σ F − m g e1, Ḣ = Σ ℓ × F.
#pragma once
#include <span>

#include "mariotte/flow/problem.hpp"
#include "mariotte/model/microbody/microbody_layout.hpp"
#include "mariotte/model/microbody/microbody_mode.hpp"

namespace mariotte::model {

/// One tip at one instant: of numbers, or of values with slopes.
template <class T>
struct BasicTipMotion {
  T indentation;          ///< δ = max(0, −n)
  T velocity;             ///< ṅ
  BasicVector3<T> lever;  ///< ℓ from the mass centre to where friction acts
  BasicVector3<T> slip;   ///< u, tangential velocity there
};
using TipMotion = BasicTipMotion<double>;

/// Contact forces on the body.
template <class T>
struct BasicTipForces {
  std::array<T, 2> normal = {0, 0};
  std::array<BasicVector3<T>, 2> friction;
  bool redundant = false;  ///< two tips stick and share friction in a way that only least norm decides
};
using TipForces = BasicTipForces<double>;

/// A body in its surroundings: what all functions below need.
struct Mechanics {
  const DimensionlessMicrobody& body;
  const MicrobodyLayout& layout;
  double slip_noise = 0;   ///< the direction of a spatial slip below it is undefined
  double force_noise = 0;  ///< sticking that needs less friction needs none

  /// Angular velocity R I⁻¹ Rᵀ H, space axes.
  Vector3 spin(ConstState x) const;
  TipMotion tip(ConstState x, Index i) const;
  double normal_force(const TipMotion& tip, Index i) const;
  /// Largest friction that the tip can hold, rounding included.
  double holding(double normal_force) const {
    return contact::limit(body.friction, normal_force) + force_noise;
  }
  /// Forces of a mode; a sticking tip gets the friction that keeps its slip constant.
  TipForces forces(ConstState x, const MicrobodyMode& mode) const;
  /// Direction in which tip i starts to slip from rest, if its friction cannot hold it: the one along which
  /// u̇ = b − μ |F_n| A û itself points, so that it stays.
  Vector3 slip_from_rest(ConstState x, const MicrobodyMode& mode, Index i) const;
  void derivative(ConstState x, const MicrobodyMode& mode, State dx) const;
  /// Places of the Jacobian of `derivative`: whole columns, of what forces and rates depend on.
  std::vector<flow::Entry> pattern() const;
  void jacobian(ConstState x, const MicrobodyMode& mode, State values) const;
  /// Energy that could lift tips out of their wells: below 0 none comes free. Kinetic, without a turn about
  /// the body's own axis and, of a body that cannot swing, motion in the plane; that of the wells; and the
  /// most that gravity can add to a swing.
  double lifting_energy(ConstState x) const;
  /// Kinetic energy, relative to space.
  double kinetic(ConstState x) const;
  /// Energy stored in the contacts, negative in the wells of adhesion.
  double stored(ConstState x) const;
  /// The same with that of the weight, if the body cannot swing: it presses the tip into its well.
  double well_energy(ConstState x) const;
};

}  // namespace mariotte::model
