#include "mariotte/study/pair_choice.hpp"

#include "mariotte/scene/restitution.hpp"

namespace mariotte::study {

impact::Pair pair_of(const scene::Scene& scene, const std::string& file, const char* what) {
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  if (!chain || chain->law.size() != 1)
    throw scene::SceneError(file + ": only two bodies of a [chain] can be " + what +
                                (std::holds_alternative<model::Microbody>(scene.model)
                                     ? "; for a [body], sweep 'incidence.normal_speed'"
                                 : chain ? "; 'mariotte check' tells the restitution of each damped contact"
                                         : ""),
                            fault::no_model);
  return {chain->law[0], scene::reduced_mass(*chain, 0)};
}

}  // namespace mariotte::study
