#include "mariotte/study/modes.hpp"

#include "mariotte/core/overload.hpp"

namespace mariotte::study {

Modes modes(const scene::Scene& scene, std::optional<double> end_force) {
  const auto of_chain = [&](const model::Chain& chain) -> Modes {
    const auto rest = impact::rest(chain, end_force);
    return {rest, vibrations(chain, rest), band_edges(chain, rest)};
  };
  const auto of_network = [&](const model::Network& network) -> Modes {
    if (end_force) throw InvalidParameter("a force presses the ends of a chain; a network has none");
    const auto rest = impact::rest(network);
    return {rest, vibrations(network, rest), {}};
  };
  const auto refuse = [](const auto&) -> Modes {
    throw scene::SceneError("only a [chain] or a [network] has modes", fault::no_model);
  };
  return std::visit(Overload{of_chain, of_network, refuse}, scene.model);
}

}  // namespace mariotte::study
