// The incident speed below which a body does not come off the plane again.
#pragma once
#include <functional>
#include <optional>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/model/microbody/microbody.hpp"

namespace mariotte::impact {

/// Two speeds with the capture velocity between them.
struct CaptureVelocity {
  double captured = 0;   ///< largest speed found at which the body is captured [m/s]
  double separated = 0;  ///< smallest speed found at which it separates [m/s]
  Index runs = 0;        ///< impacts simulated

  double value() const { return 0.5 * (captured + separated); }
};

/// The body as it strikes at a normal speed [m/s]; its damping may depend on the speed.
using BodyAtSpeed = std::function<model::Microbody(double speed)>;

/// Brackets the capture velocity from `guess` by factors of two, then by where the square of the rebound
/// vanishes, until the bracket is `tolerance` wide, relative to its speed, or as narrow as runs can tell:
/// they are more exact than `options` ask if the tolerance needs it. Empty if factors up to 2²⁰ on either
/// side find none: a body without damping is never captured. Where several speeds part capture from
/// separation, which bodies other than spheres admit, one of them is found. Throws Error if a run fails or
/// reaches a limit.
std::optional<CaptureVelocity> capture_velocity(const BodyAtSpeed& body, double guess, double tolerance,
                                                const hybrid::Options& options = {});

}  // namespace mariotte::impact
