// What closed forms of a pair say and are asked.
#pragma once
#include "mariotte/core/types.hpp"

namespace mariotte::flow {

/// Indentation and its rate at one time.
struct Indentation {
  double value;  ///< δ
  double rate;   ///< δ̇
};

/// The indentation that is reached after a time; infinite if it never is.
struct Reached {
  double time;
  Indentation there;
};

/// A gap elsewhere while the contact is closed: g(t) = value + rate t + share (δ(t) − δ(0)) with share ≥ 0.
/// As long as the contact pushes δ is concave, and so is g: it falls through zero once at most, and it does
/// so exactly when it is not positive at the end.
struct ConcaveGap {
  double value;
  double rate;
  double coupling;
};

}  // namespace mariotte::flow
