// Balls with friction by methods that locate no events, as users write them.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "mariotte/model/bodies/bodies.hpp"
#include "measuring/timing.hpp"

namespace mariotte::work_precision {

/// Run time [s] and error at one setting.
struct RivalPoint {
  double seconds, error;
};

/// From the loosest setting to the tightest, until one takes too long; empty for what the rival does not
/// know.
struct FrictionRivals {
  std::vector<RivalPoint> odeint, verlet;
};

/// Two velocities and spin × radius of each ball → the error.
using VelocityError = std::function<double(const std::vector<double>&)>;

/// Boost.odeint's Dormand–Prince pair with step control, and velocity Verlet with a fixed step, up to a time.
FrictionRivals friction_rivals(const model::Bodies& bodies, double end, const VelocityError& error,
                               const measuring::Patience& patience);

/// The least time with an error up to `accuracy`.
std::optional<double> least_time(const std::vector<RivalPoint>& points, double accuracy);

}  // namespace mariotte::work_precision
