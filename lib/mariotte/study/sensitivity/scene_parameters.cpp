#include "mariotte/study/sensitivity/scene_parameters.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "mariotte/core/overload.hpp"
#include "mariotte/scene/field.hpp"
#include "mariotte/study/sensitivity/capture_slopes.hpp"
#include "mariotte/study/sensitivity/scene_numbers.hpp"
#include "mariotte/study/sensitivity/swept_slopes.hpp"

namespace mariotte::study {
namespace {

using scene::Document;

/// "mass" and 7 of "mass[7].x"; no number where there is no index.
std::pair<std::string, std::optional<Index>> name_and_index(const std::string& key) {
  const auto open = key.find('[');
  if (open == key.npos) return {key, {}};
  Index index = 0;
  const auto [end, problem] = std::from_chars(key.data() + open + 1, key.data() + key.size(), index);
  return {key.substr(0, open), problem == std::errc() ? std::optional(index) : std::nullopt};
}

/// An index beyond the last of numbers that the model has.
template <class Model>
void expect_within(const Document& document, const std::string& key,
                   const std::vector<impact::Parameter<Model>>& all) {
  const auto [name, index] = name_and_index(key);
  std::optional<Index> last;
  for (const auto& one : all)
    if (const auto [of, at] = name_and_index(one.name); of == name) last = std::max(last, at);
  if (!index || !last || *index <= *last) return;
  auto source = document.source;
  reject(source, add_origin(source, "--to " + key), fault::leads_nowhere,
         "the last is " + name + "[" + std::to_string(*last) + "]");
}

template <class Model>
std::vector<impact::Parameter<Model>> chosen(const Document& document, const std::vector<std::string>& keys,
                                             const std::vector<impact::Parameter<Model>>& all) {
  if (keys.empty()) return all;
  std::vector<impact::Parameter<Model>> list;
  for (const auto& key : keys) {
    const auto before = list.size();
    for (const auto& one : all)
      if (is_asked_for(one.name, key)) list.push_back(one);
    if (list.size() > before) continue;
    expect_within(document, key, all);
    for (const auto& one : elements_of(document, key))
      list.push_back(number_of_scene<Model>(document, one, one));
  }
  return list;
}

struct NamedKey {
  const char* name;
  const char* key;
};
/// What a body and its surface are made from, by the symbols that their page uses.
constexpr std::array<NamedKey, 16> of_body{{{"radius", "body.radius"},
                                            {"diameter", "body.diameter"},
                                            {"density", "body.density"},
                                            {"length_ratio", "body.length_ratio"},
                                            {"stiffness", "surface.stiffness"},
                                            {"work_of_adhesion", "surface.work_of_adhesion"},
                                            {"zeta_hertz", "surface.zeta_hertz"},
                                            {"zeta_adhesion", "surface.zeta_adhesion"},
                                            {"C_H", "surface.damping_hertz"},
                                            {"C_A", "surface.damping_adhesion"},
                                            {"friction", "surface.friction"},
                                            {"normal_speed", "incidence.normal_speed"},
                                            {"v2", "incidence.tangential_velocity[0]"},
                                            {"v3", "incidence.tangential_velocity[1]"},
                                            {"w2", "incidence.spin[1]"},
                                            {"w3", "incidence.spin[2]"}}};

/// What the scene gives and is not zero, and what is asked for by its name.
std::vector<impact::Parameter<model::Microbody>> all_of_body(const Document& document,
                                                             const std::vector<std::string>& asked) {
  std::vector<impact::Parameter<model::Microbody>> list;
  for (const auto& [name, key] : of_body) {
    if (std::find(asked.begin(), asked.end(), name) != asked.end()) {
      list.push_back(number_of_scene<model::Microbody>(document, name, key));
      continue;
    }
    std::optional<SceneNumber> number;
    try {
      number = number_at(document, key);
    } catch (const scene::SceneError&) {
      continue;  // the scene does not give it
    }
    if (number && number->value != 0 && std::isfinite(number->value))
      list.push_back(number_of_scene<model::Microbody>(document, name, key));
  }
  return list;
}

/// `of(model, parameters)` of a scene; those of a body are `parameters_of_body()`.
template <class Of, class OfBody>
impact::Sensitivity slopes_of(const scene::Scene& scene, Of&& of, OfBody&& parameters_of_body) {
  return std::visit(
      Overload{[&](const model::Chain& chain) { return of(chain, impact::parameters(chain)); },
               [&](const model::Network& network) { return of(network, impact::parameters(network)); },
               [&](const model::Microbody& body) { return of(body, parameters_of_body()); },
               [&](const model::Bodies& bodies) { return of(bodies, impact::parameters(bodies)); },
               [](const scene::LawAlone& nothing) -> impact::Sensitivity { scene::refuse(nothing); }},
      scene.model);
}

}  // namespace

std::vector<impact::Parameter<model::Chain>> chain_parameters(const Document& document,
                                                              const model::Chain& chain,
                                                              const std::vector<std::string>& keys) {
  return chosen(document, keys, impact::parameters(chain));
}

std::vector<impact::Parameter<model::Microbody>> body_parameters(const Document& document,
                                                                 const std::vector<std::string>& keys) {
  return chosen(document, keys, all_of_body(document, keys));
}

namespace {

/// The outcome that a key of a result leads to: "velocity[2]" for "final.velocity[2]", "impulse[1]" for
/// "contacts[1].impulse"; others stay.
std::string as_outcome(std::string key) {
  constexpr std::string_view final = "final.", contacts = "contacts[", impulse = "].impulse";
  if (key.starts_with(final)) return key.substr(final.size());
  if (key == "energy.dissipated") return "dissipated";
  if (key.starts_with(contacts) && key.ends_with(impulse))
    return "impulse[" + key.substr(contacts.size(), key.find(']') - contacts.size()) + "]";
  return key;
}

std::vector<std::string> as_outcomes(std::vector<std::string> keys) {
  for (auto& key : keys) key = as_outcome(key);
  return keys;
}

}  // namespace

impact::Sensitivity sensitivity(const Document& document, const scene::Scene& scene,
                                const std::vector<std::string>& keys, const std::vector<std::string>& of,
                                const impact::SlopeWatch& watch) {
  const auto outcomes = as_outcomes(of);
  if (std::find(outcomes.begin(), outcomes.end(), capture_velocity_name) != outcomes.end()) {
    if (outcomes.size() > 1)
      throw InvalidParameter("capture_velocity is asked for alone: other outcomes are those of one run");
    return sensitivity_of_capture(document, keys, watch);
  }
  const bool moves_end = std::any_of(keys.begin(), keys.end(),
                                     [&](const std::string& key) { return is_time_limit(document, key); });
  if (const auto ball = moves_end ? std::nullopt : swept_ball(scene, outcomes))
    return sensitivity_of_velocity(document, scene, keys, *ball, watch);
  return slopes_of(
      scene,
      [&](const auto& model, const auto& all) {
        return impact::sensitivity(model, chosen(document, keys, all), scene.run, watch);
      },
      [&] { return all_of_body(document, keys); });
}

std::vector<std::string> number_names(const Document& document, const scene::Scene& scene) {
  std::vector<std::string> names;
  const auto add = [&](const auto& all) {
    for (const auto& one : all) names.push_back(one.name);
  };
  std::visit(Overload{[&](const model::Microbody&) { add(all_of_body(document, {})); },
                      [&](const auto& model) { add(impact::parameters(model)); },
                      [](const scene::LawAlone& nothing) { scene::refuse(nothing); }},
             scene.model);
  return names;
}

impact::Sensitivity outcomes(const scene::Scene& scene) {
  return slopes_of(
      scene,
      [&]<class Model>(const Model& model, const std::vector<impact::Parameter<Model>>&) {
        return impact::sensitivity(model, std::vector<impact::Parameter<Model>>{}, scene.run);
      },
      [] { return std::vector<impact::Parameter<model::Microbody>>{}; });
}

void keep_asked_for(std::vector<impact::OutcomeSlopes>& all, const std::vector<std::string>& keys) {
  const auto of = as_outcomes(keys);
  const auto is_wanted = [](const auto& one, const auto& key) { return is_asked_for(name_of(one), key); };
  for (const auto& key : of)
    if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return is_wanted(one, key); })) {
      std::string names;
      for (const auto& one : all) names += (names.empty() ? "" : ", ") + name_of(one);
      throw UnknownOutcome(key + ": no such outcome; there are " + names);
    }
  if (of.empty()) return;
  std::erase_if(all, [&](const auto& one) {
    return std::none_of(of.begin(), of.end(), [&](const auto& key) { return is_wanted(one, key); });
  });
}

}  // namespace mariotte::study
