#include "mariotte/study/fit/fit_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/overload.hpp"
#include "mariotte/impact/watch/chain_run.hpp"
#include "mariotte/study/fit/fit_model.hpp"

namespace mariotte::study {
namespace {

constexpr double share = 0.01;  // of a value, within which a scene exists four times

std::string outcome_of_contacts(const std::string& key) {
  constexpr std::string_view velocity = "final.velocity[", contact = "contacts[", impulse = "].impulse";
  if (key == "final.time") return "time";
  if (key.starts_with("icr[")) return key;
  if (key.starts_with(velocity)) return key.substr(key.find('.') + 1);
  if (!key.starts_with(contact) || !key.ends_with(impulse)) return "";
  const auto index = key.find('[');
  return "impulse" + key.substr(index, key.find(']') + 1 - index);
}

std::string outcome_of(const std::string& key, const scene::Scene& scene) {
  if (std::holds_alternative<model::Microbody>(scene.model))
    return key == "restitution.tip" ? "e_n" : key == "restitution.centre" ? "e_nm" : "";
  return std::holds_alternative<model::Bodies>(scene.model) ? "" : outcome_of_contacts(key);
}

/// Slopes would follow a row as a whole that is divided into islands.
bool divides(const scene::Scene& scene) {
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  return chain && impact::divides(scene.run, *chain);
}

}  // namespace

std::vector<std::string> outcomes_of(const std::vector<std::string>& keys, const scene::Scene& scene) {
  std::vector<std::string> outcomes;
  for (const auto& key : keys) outcomes.push_back(outcome_of(key, scene));
  if (std::find(outcomes.begin(), outcomes.end(), "") != outcomes.end()) return {};
  return outcomes;
}

model::Microbody first_impact(model::Microbody body) {
  body.impacts = 1;
  body.after_capture = model::AfterCapture::stop;
  return body;
}

Slopes slopes_of(const impact::Sensitivity& found, const std::string& outcome) {
  using hybrid::Ending;
  const auto count = found.parameter.size();
  const auto is_it = [&](const auto& one) { return name_of(one) == outcome; };
  const auto one = std::find_if(found.outcome.begin(), found.outcome.end(), is_it);
  const bool has_end = found.ending == Ending::separated || found.ending == Ending::time_limit;
  if (!has_end || found.in_doubt || one == found.outcome.end() || !one->value) return Slopes(count);
  auto slopes = one->slope;
  for (std::size_t i = 0; i < count; ++i)
    if (slopes[i] && impact::is_rounding(*slopes[i], found.parameter[i].value, *one->value)) slopes[i] = 0;
  return slopes;
}

/// A free key as a parameter: the scene is read again with other values.
template <class Model>
std::vector<impact::Parameter<Model>> FitModel::parameters(std::span<const double> values) {
  std::vector<impact::Parameter<Model>> list;
  for (std::size_t i = 0; i < values.size(); ++i)
    list.push_back(
        {free_[i], values[i], share * values[i], [this, i, value = values[i]](double to, Model& moved) {
           set_free(i, to);
           auto scene = resolve(document_);
           set_free(i, value);
           moved = std::move(std::get<Model>(scene.model));
           if constexpr (std::is_same_v<Model, model::Microbody>) moved = first_impact(moved);
         }});
  return list;
}

impact::Sensitivity FitModel::sensitivity(const scene::Scene& scene, std::span<const double> values) {
  const auto of = [&]<class Model>(const Model& model) {
    return impact::sensitivity(model, parameters<Model>(values), scene.run, watch_);
  };
  return std::visit(Overload{[&](const model::Chain& chain) { return of(chain); },
                             [&](const model::Network& network) { return of(network); },
                             [&](const model::Microbody& body) { return of(first_impact(body)); },
                             [](const auto&) -> impact::Sensitivity { return {}; }},
                    scene.model);
}

/// Of (v₁ − v₀)/(u₀ − u₁), where the start velocities u stay.
Slopes FitModel::of_pair(const impact::Sensitivity& found, const model::Chain& chain) const {
  const auto first = slopes_of(found, outcomes_[0]), second = slopes_of(found, outcomes_[1]);
  const double approach = chain.velocity[0] - chain.velocity[1];
  Slopes slopes(free_.size());
  for (std::size_t i = 0; i < slopes.size(); ++i)
    if (first[i] && second[i] && !free_[i].starts_with("chain.velocity"))
      slopes[i] = (*second[i] - *first[i]) / approach;
  return slopes;
}

Slopes FitModel::slopes_of_row(std::size_t row, std::span<const double> values) try {
  if (outcomes_.empty()) return Slopes(free_.size());
  const auto scene = scene_at(measurements_.rows[row].values, values);
  if (divides(scene)) return Slopes(free_.size());
  const auto found = sensitivity(scene, values);
  ++runs_;
  ++runs_with_slopes_;
  const bool is_held = found.ending == hybrid::Ending::captured || found.ending == hybrid::Ending::bound;
  if (is_held && measurements_.quantity.starts_with("restitution")) return Slopes(free_.size(), 0.0);
  return outcomes_.size() == 1 ? slopes_of(found, outcomes_[0])
                               : of_pair(found, std::get<model::Chain>(scene.model));
} catch (const Error&) {
  return Slopes(free_.size());  // what is driven, or has a number that cannot move by so much
}

}  // namespace mariotte::study
