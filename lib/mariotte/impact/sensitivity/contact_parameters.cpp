#include <cmath>
#include <memory>

#include "mariotte/impact/sensitivity/law_parameters.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"

namespace mariotte::impact {
namespace {

std::string numbered(const char* name, std::size_t i) {
  return name + ("[" + std::to_string(i) + "]");
}

template <class Model>
using List = std::vector<Parameter<Model>>;

/// By all parameters of a model: each moves a copy.
template <class Model>
using Shared = std::shared_ptr<const Model>;

using Known = std::optional<Dimension>;

/// The elements of a list of the model, each with the step that its value asks for.
template <class Model, class Step>
void add_elements(const Shared<Model>& model, std::vector<double> Model::*list, const char* name, Step&& step,
                  const Known& dimension, bool is_linear, List<Model>& parameters) {
  for (std::size_t i = 0; i < ((*model).*list).size(); ++i) {
    const double value = ((*model).*list)[i];
    if (std::isinf(value)) continue;
    const auto move = [model, list, i](double to, Model& other) {
      other = *model;
      (other.*list)[i] = to;
    };
    parameters.push_back({numbered(name, i), value, step(value), move, dimension, is_linear});
  }
}

template <class Model>
void add_laws(const Shared<Model>& model, List<Model>& parameters) {
  for (std::size_t j = 0; j < model->law.size(); ++j)
    for (auto& number : law_parameters(model->law[j])) {
      const auto move = [model, j, law = std::move(number.law)](double to, Model& other) {
        other = *model;
        other.law[j] = law(to);
      };
      parameters.push_back({numbered("contact", j) + "." + number.key, number.value, number.step, move,
                            number.dimension, number.is_linear});
    }
}

/// Velocities and gaps are the state at the start, which is linear in them.
template <class Model>
List<Model> common(const Shared<Model>& model, bool has_masses, bool has_balls) {
  const auto share = [](double value) { return stencil_share * value; };
  const auto unit = [](double) { return 1.0; };
  const auto of_balls = [&](const Dimension& dimension) { return has_balls ? Known(dimension) : Known(); };
  List<Model> list;
  if (has_masses) add_elements(model, &Model::mass, "mass", share, of_balls(dimension::mass), false, list);
  add_elements(model, &Model::velocity, "velocity", unit, of_balls(dimension::velocity), true, list);
  add_elements(model, &Model::gap, "gap", unit, dimension::length, true, list);
  add_laws(model, list);
  return list;
}

}  // namespace

std::vector<Parameter<model::Chain>> parameters(const model::Chain& chain) {
  const auto shared = std::make_shared<const model::Chain>(chain);
  auto list = common(shared, true, true);
  if (chain.gravity == 0) return list;
  const auto move = [shared](double to, model::Chain& other) {
    other = *shared;
    other.gravity = to;
  };
  list.push_back({"gravity", chain.gravity, std::abs(chain.gravity), move, dimension::acceleration, true});
  return list;
}

std::vector<Parameter<model::Network>> parameters(const model::Network& network) {
  const bool diagonal = model::is_diagonal(network.mass, std::ssize(network.velocity));
  return common(std::make_shared<const model::Network>(network), diagonal, network.dimension > 0);
}

}  // namespace mariotte::impact
