#include "mariotte/scene/simulate.hpp"

#include "mariotte/core/overload.hpp"
#include "mariotte/scene/judge.hpp"

namespace mariotte::scene {

Impact simulate(const Scene& scene, const impact::RunObserver& observers) {
  const auto result = [&](const auto& model) -> Impact {
    auto impact = impact::simulate(model, scene.run, observers);
    judge(impact, scene);
    return impact;
  };
  return std::visit(Overload{[&](const model::Chain& chain) { return result(chain); },
                             [&](const model::Network& network) { return result(network); },
                             [&](const model::Microbody& body) { return result(body); },
                             [&](const model::Bodies& bodies) { return result(bodies); },
                             [](const LawAlone& nothing) -> Impact { refuse(nothing); }},
                    scene.model);
}

}  // namespace mariotte::scene
