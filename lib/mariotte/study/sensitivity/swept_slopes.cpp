#include "mariotte/study/sensitivity/swept_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"
#include "mariotte/impact/watch/chain_run.hpp"
#include "mariotte/study/sensitivity/scene_numbers.hpp"

namespace mariotte::study {
namespace {

using scene::Document;

std::optional<double> known(double slope) {
  return std::isnan(slope) ? std::nullopt : std::optional(slope);
}

/// Those by `keys` of the slopes by all numbers of a row.
void choose(const Document& document, const std::vector<std::string>& keys, const impact::RowSlopes& slopes,
            impact::Sensitivity& result) {
  const auto all = std::exchange(result.parameter, {});
  const auto by_all = std::exchange(result.outcome[0].slope, {});
  const auto add = [&](const impact::ParameterValue& parameter, std::optional<double> slope) {
    result.parameter.push_back(parameter);
    result.outcome[0].slope.push_back(slope);
  };
  for (const auto& key : keys) {
    const auto before = result.parameter.size();
    for (std::size_t i = 0; i < all.size(); ++i)
      if (is_asked_for(all[i].name, key)) add(all[i], by_all[i]);
    if (result.parameter.size() > before) continue;
    for (const auto& one : elements_of(document, key)) {
      const auto number = number_of_scene<model::Chain>(document, one, one);
      if (number.limit != 0) throw InvalidParameter(one + ": slopes by the time limit are not swept back");
      add({one, number.value}, known(slope_by(slopes, number)));
    }
  }
  note_waiting(result);
}

struct Outcome {
  std::string name;
  std::optional<Index> index;
  std::vector<double> weights;
};

impact::Sensitivity swept(const Document& document, const scene::Scene& scene,
                          const std::vector<std::string>& keys, const Outcome& outcome,
                          const impact::SlopeWatch& watch) {
  const auto& chain = std::get<model::Chain>(scene.model);
  const auto found = impact::adjoint(chain, outcome.weights, scene.run, watch);
  auto result = as_sensitivity(chain, found, outcome.name, outcome.index);
  if (!keys.empty()) choose(document, keys, found.slopes, result);
  return result;
}

}  // namespace

bool sweeps_back(const scene::Scene& scene) {
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  return chain && !impact::why_no_adjoint(*chain);
}

std::optional<Index> swept_ball(const scene::Scene& scene, const std::vector<std::string>& outcomes) {
  if (outcomes.size() != 1 || !sweeps_back(scene)) return {};
  const auto& chain = std::get<model::Chain>(scene.model);
  if (!impact::divides(scene.run, chain)) return {};
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    if (outcomes[0] == "velocity[" + std::to_string(i) + "]") return static_cast<Index>(i);
  return {};
}

impact::Sensitivity sensitivity_of_velocity(const Document& document, const scene::Scene& scene,
                                            const std::vector<std::string>& keys, Index ball,
                                            const impact::SlopeWatch& watch) {
  std::vector<double> weights(std::get<model::Chain>(scene.model).mass.size());
  weights[static_cast<std::size_t>(ball)] = 1;
  return swept(document, scene, keys, {"velocity", ball, weights}, watch);
}

impact::Sensitivity sensitivity_of_sum(const Document& document, const scene::Scene& scene,
                                       const std::vector<std::string>& keys,
                                       const std::vector<double>& weights, const impact::SlopeWatch& watch) {
  if (!std::holds_alternative<model::Chain>(scene.model))
    throw InvalidParameter("slopes are computed backwards of rows alone");
  return swept(document, scene, keys, {"sum", {}, weights}, watch);
}

}  // namespace mariotte::study
