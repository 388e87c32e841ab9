#include "mariotte/scene/judge.hpp"

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

}  // namespace mariotte::scene
