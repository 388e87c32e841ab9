#include "mariotte/impact/microbody/capture_velocity.hpp"

#include "mariotte/core/error.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"

namespace mariotte::impact {

std::optional<CaptureVelocity> capture_velocity(const BodyAtSpeed& body, double guess, double tolerance,
                                                const hybrid::Options& options) {
  constexpr int most_doublings = 20;
  MicrobodySolver solver;
  CaptureVelocity found;
  const auto is_captured = [&](double speed) {
    ++found.runs;
    const auto& impact = solver.solve(body(speed), options);
    if (impact.ending != hybrid::Ending::separated && impact.ending != hybrid::Ending::captured)
      throw Error(std::string("a run ended with ") + hybrid::name(impact.ending) + ": " + impact.message);
    return impact.ending == hybrid::Ending::captured;
  };

  const bool start = is_captured(guess);
  double near = guess, far = guess;
  for (int i = 0; far == near; ++i) {
    if (i == most_doublings) return std::nullopt;
    const double next = start ? 2 * near : 0.5 * near;
    if (is_captured(next) == start)
      near = far = next;
    else
      far = next;
  }
  found.captured = start ? near : far;
  found.separated = start ? far : near;
  while (found.separated - found.captured > tolerance * found.value()) {
    const double middle = found.value();
    if (middle <= found.captured || middle >= found.separated) break;  // the two are neighbours as numbers
    (is_captured(middle) ? found.captured : found.separated) = middle;
  }
  return found;
}

}  // namespace mariotte::impact
