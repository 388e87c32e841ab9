#include "mariotte/report/sweep_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/core/counted.hpp"
#include "mariotte/report/limit_count.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_of_scenes = 3;

/// What points have to be warned of.
struct Found {
  LimitCount limits;
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
  found.limits.look(scene);
} catch (const Error&) {
}

}  // namespace

std::vector<std::string> warnings(const study::SweepPlan& plan) {
  study::Variation variation(plan.document, plan.design, std::nullopt);
  const auto points = some_of(plan.design.points());
  Found found;
  for (const Index point : points) look(variation, plan, point, found);
  auto list = std::move(found.of_scenes);
  for (auto& one : found.limits.sentences(points.size(), "points", "--column"))
    list.push_back(std::move(one));
  return list;
}

std::string less_exact(Index points) {
  return fmt::format("velocities of {} may be less exact than was asked, as the reason of each says",
                     counted(points, "point"));
}

}  // namespace mariotte::report
