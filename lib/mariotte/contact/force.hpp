// What every contact law returns: the force together with its slopes.
#pragma once

namespace mariotte::contact {

/// Normal force of a closed contact and its partial derivatives.
struct Force {
  double value;           ///< f ≥ 0, pushing apart [N]
  double by_indentation;  ///< ∂f/∂δ [N/m]
  double by_rate;         ///< ∂f/∂δ̇ [N s/m]
};

}  // namespace mariotte::contact
