// An adhesive sphere that strikes a plane along the normal; many are followed side by side.
#pragma once

namespace mariotte::flow {

/// Dimensionless: its mass and the stiffness of the contact are 1, its incident speed is about 1. The force
/// is
///
///     F = δ^{3/2} (1 + c_H δ̇) − b √δ (1 − c_A δ̇)
struct Sphere {
  double adhesion;          ///< b
  double damping_hertz;     ///< c_H
  double damping_adhesion;  ///< c_A
  double weight;            ///< by which the well of adhesion magnifies errors
  double noise_energy;      ///< what energies cannot be told from 0 by
  double rate;              ///< δ̇, of the approach and at the end
  double time = 0;
  int steps = 0;
  bool separates = false;  ///< else it stays, or another solver has to tell
};

}  // namespace mariotte::flow
