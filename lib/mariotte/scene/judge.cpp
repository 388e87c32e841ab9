#include "mariotte/scene/judge.hpp"

#include "mariotte/core/overload.hpp"
#include "mariotte/impact/assess.hpp"

namespace mariotte::scene {

void judge(impact::ChainImpact& impact, const Scene& scene) {
  assess(impact, std::get<model::Chain>(scene.model).law, scene.touching);
}

void judge(impact::NetworkImpact& impact, const Scene& scene) {
  assess(impact, std::get<model::Network>(scene.model).law, scene.touching);
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
