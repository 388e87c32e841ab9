#include "mariotte/report/sweep_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mariotte/scene/simulate.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::report {
namespace {

constexpr Index least_points = 2, most_points = 24, share_of_points = 10;

/// Points beyond each limit.
using Counts = std::array<Index, impact::validity_limits.size()>;

/// A point without a result has no validity, either.
void count(study::Variation& variation, Index point, Counts& beyond) try {
  const auto impact = scene::simulate(variation.at(point));
  const auto& validity =
      std::visit([](const auto& one) -> const impact::Validity& { return one.validity; }, impact);
  for (std::size_t i = 0; i < beyond.size(); ++i)
    beyond[i] += is_beyond(impact::validity_limits[i], validity);
} catch (const Error&) {
}

}  // namespace

std::vector<std::string> warnings(const study::SweepPlan& plan) {
  study::Variation variation(plan.document, plan.design, std::nullopt);
  const Index points = plan.design.points(),
              looked_at = std::min(points, std::clamp(points / share_of_points, least_points, most_points));
  Counts beyond{};
  for (Index k = 0; k < looked_at; ++k)
    count(variation, looked_at == 1 ? 0 : k * (points - 1) / (looked_at - 1), beyond);
  std::vector<std::string> list;
  for (std::size_t i = 0; i < beyond.size(); ++i) {
    const auto& one = impact::validity_limits[i];
    if (beyond[i] == 0) continue;
    list.push_back(fmt::format("at {} of {} points that were looked at, {} is {} {:g}: {} (--column {})",
                               beyond[i], looked_at, one.symbol, one.from_below ? "above" : "below",
                               one.limit, one.otherwise, one.key));
  }
  return list;
}

}  // namespace mariotte::report
