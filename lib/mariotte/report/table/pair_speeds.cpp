#include "mariotte/report/table/pair_speeds.hpp"

#include <cmath>

namespace mariotte::report {
namespace {

/// Rate of the gap after a flight that lasts so long: gravity acts on balls, and not on walls.
double gap_rate(const model::Chain& chain, const std::vector<double>& velocity, double flight) {
  const auto at = [&](std::size_t i) {
    return velocity[i] - (std::isinf(chain.mass[i]) ? 0 : chain.gravity * flight);
  };
  return at(1) - at(0);
}

}  // namespace

std::optional<PairSpeeds> pair_speeds(const impact::ChainImpact& impact, const model::Chain& chain) {
  if (impact.contacts.size() != 1 || impact.contacts[0].periods.size() != 1) return std::nullopt;
  const auto& period = impact.contacts[0].periods[0];
  if (!period.end || chain.gap[0] < 0) return std::nullopt;
  const PairSpeeds speeds{.approach = -gap_rate(chain, chain.velocity, period.start),
                          .separation = gap_rate(chain, impact.velocity, *period.end - impact.time)};
  return speeds.approach > 0 ? std::optional(speeds) : std::nullopt;
}

}  // namespace mariotte::report
