#include "mariotte/impact/microbody/capture_velocity.hpp"

#include <algorithm>

#include "mariotte/core/error.hpp"
#include "mariotte/hybrid/reached_limit.hpp"
#include "mariotte/impact/capture_bracket.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/impact/passage.hpp"

namespace mariotte::impact {

namespace {
constexpr double share = 1.0 / 64;  ///< of the tolerance that runs may be off
}

std::optional<CaptureVelocity> capture_velocity(const BodyAtSpeed& body, double guess, double tolerance,
                                                const hybrid::Options& options) {
  MicrobodySolver solver;
  auto precise = options;
  precise.accuracy = std::clamp(share * tolerance, Passage{}.attainable, options.accuracy);
  const auto rebound = [&](double speed) {
    const auto& impact = solver.solve(body(speed), precise);
    if (impact.ending != hybrid::Ending::separated && impact.ending != hybrid::Ending::captured)
      throw Error(std::string("a run ended with ") + hybrid::name(impact.ending) + ": " +
                  (impact.message.empty() ? reached_limit(impact.ending, options) : impact.message));
    const double comes_off = impact.ending == hybrid::Ending::captured ? 0 : impact.tip_velocity;
    return ReboundSpeed{comes_off, speed * impact.estimated_accuracy.value_or(0)};
  };
  return bracket_capture(rebound, guess, tolerance);
}

}  // namespace mariotte::impact
