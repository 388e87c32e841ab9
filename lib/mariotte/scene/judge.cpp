#include "mariotte/scene/judge.hpp"

#include <algorithm>

#include "mariotte/core/overload.hpp"
#include "mariotte/impact/assess.hpp"
#include "mariotte/scene/missed_meetings.hpp"

namespace mariotte::scene {

void judge(impact::ChainImpact& impact, const Scene& scene) {
  assess(impact, std::get<model::Chain>(scene.model).law, scene.touching);
}

namespace {

/// From where the balls were at the start, which the impact has hardly moved; beside those that the scene has
/// been warned of.
std::vector<std::pair<Index, Index>> missed_afterwards(const impact::NetworkImpact& impact,
                                                       const Scene& scene) {
  if (impact.ending != hybrid::Ending::separated || scene.ball.empty()) return {};
  auto balls = scene.ball;
  auto velocity = impact.velocity.begin();
  for (auto& ball : balls)
    for (double& one : ball.velocity) one = *velocity++;
  auto missed = missed_meetings(balls, scene.reach);
  if (missed.empty()) return {};
  const auto told = missed_meetings(scene.ball, scene.reach);
  std::erase_if(missed, [&](const auto& pair) { return std::ranges::find(told, pair) != told.end(); });
  return missed;
}

}  // namespace

void judge(impact::NetworkImpact& impact, const Scene& scene) {
  assess(impact, std::get<model::Network>(scene.model).law, scene.touching);
  impact.missed = missed_afterwards(impact, scene);
}

void judge(impact::MicrobodyImpact& impact, const Scene& scene) {
  assess(impact, std::get<model::Microbody>(scene.model), scene.touching);
}

void judge(impact::BodiesImpact& impact, const Scene& scene) {
  assess(impact, std::get<model::Bodies>(scene.model), scene.touching);
}

bool has_validity(const Scene& scene) {
  const auto of_contacts = [&](const auto& model) { return impact::has_validity(model.law, scene.touching); };
  return std::visit(
      Overload{[&](const model::Chain& chain) { return of_contacts(chain); },
               [&](const model::Network& network) { return of_contacts(network); },
               [](const model::Microbody&) { return true; }, [](const model::Bodies&) { return true; },
               [](const LawAlone&) { return false; }},
      scene.model);
}

}  // namespace mariotte::scene
