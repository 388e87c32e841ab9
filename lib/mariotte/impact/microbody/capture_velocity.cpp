#include "mariotte/impact/microbody/capture_velocity.hpp"

#include "mariotte/core/error.hpp"
#include "mariotte/hybrid/reached_limit.hpp"
#include "mariotte/impact/capture_bracket.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"

namespace mariotte::impact {

std::optional<CaptureVelocity> capture_velocity(const BodyAtSpeed& body, double guess, double tolerance,
                                                const hybrid::Options& options) {
  MicrobodySolver solver;
  const auto rebound = [&](double speed) {
    const auto& impact = solver.solve(body(speed), options);
    if (impact.ending != hybrid::Ending::separated && impact.ending != hybrid::Ending::captured)
      throw Error(std::string("a run ended with ") + hybrid::name(impact.ending) + ": " +
                  (impact.message.empty() ? reached_limit(impact.ending, options) : impact.message));
    return impact.ending == hybrid::Ending::captured ? 0 : impact.tip_velocity;
  };
  return bracket_capture(rebound, guess, tolerance);
}

}  // namespace mariotte::impact
