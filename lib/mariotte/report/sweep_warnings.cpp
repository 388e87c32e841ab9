#include "mariotte/report/sweep_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mariotte/scene/judge.hpp"
#include "mariotte/scene/simulate.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::report {
namespace {

constexpr Index least_points = 2, most_points = 8, share_of_points = 10;
constexpr std::size_t most_of_scenes = 3;

/// What points have to be warned of.
struct Found {
  std::array<Index, impact::validity_limits.size()> beyond = {};  ///< points, by limit
  std::vector<std::string> of_scenes = {};
};

/// What has not been said, by the sweep or of another point.
void note(const scene::Scene& scene, const study::SweepPlan& plan, Index point, Found& found) {
  const auto is_in = [](const auto& list, const std::string& text) {
    return std::ranges::any_of(list, [&](const auto& one) { return one.ends_with(text); });
  };
  for (const auto& one : scene.warnings)
    if (found.of_scenes.size() < most_of_scenes && !is_in(plan.warnings, one) && !is_in(found.of_scenes, one))
      found.of_scenes.push_back(fmt::format("row {}: {}", point + 1, one));
}

/// A point without a result has no validity, either.
void look(study::Variation& variation, const study::SweepPlan& plan, Index point, Found& found) try {
  const auto& scene = variation.at(point);
  note(scene, plan, point, found);
  if (!has_validity(scene)) return;
  const auto impact = scene::simulate(scene);
  const auto& validity =
      std::visit([](const auto& one) -> const impact::Validity& { return one.validity; }, impact);
  for (std::size_t i = 0; i < found.beyond.size(); ++i)
    found.beyond[i] += is_beyond(impact::validity_limits[i], validity);
} catch (const Error&) {
}

}  // namespace

std::vector<std::string> warnings(const study::SweepPlan& plan) {
  study::Variation variation(plan.document, plan.design, std::nullopt);
  const Index points = plan.design.points(),
              looked_at = std::min(points, std::clamp(points / share_of_points, least_points, most_points));
  Found found;
  for (Index k = 0; k < looked_at; ++k)
    look(variation, plan, looked_at == 1 ? 0 : k * (points - 1) / (looked_at - 1), found);
  auto list = std::move(found.of_scenes);
  for (std::size_t i = 0; i < found.beyond.size(); ++i) {
    const auto& one = impact::validity_limits[i];
    if (found.beyond[i] == 0) continue;
    list.push_back(fmt::format("at {} of {} points that were looked at, {} is {} {:g}: {} (--column {})",
                               found.beyond[i], looked_at, one.symbol, one.from_below ? "above" : "below",
                               one.limit, one.otherwise, one.key));
  }
  return list;
}

}  // namespace mariotte::report
