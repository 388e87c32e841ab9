#include "mariotte/report/json/json.hpp"

#include "mariotte/core/overload.hpp"
#include "mariotte/impact/quantities/quantity.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/reason.hpp"

namespace mariotte::report {
namespace {

using impact::Indices;
using impact::Quantity;

struct AsJson {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(impact::Omitted) const { return nullptr; }
  Json operator()(std::string_view words) const { return std::string(words); }
  template <class Plain>
  Json operator()(Plain value) const {
    return value;
  }
};

/// A quantity, and the indices that lead to one of its values.
template <class Impact>
struct Place {
  const Impact& impact;
  const Quantity<Impact>& quantity;
  Indices at = {};
};

/// The elements of an array: its values, or a null each for members that are still to come.
template <class Impact>
Json array(Place<Impact>& place, Index& last) {
  const auto& [impact, quantity, at] = place;
  const auto count = quantity.count(impact, at);
  if (!count) return nullptr;
  Json elements = Json::array();
  for (last = 0; last < *count; ++last)
    elements.push_back(quantity.read ? std::visit(AsJson(), quantity.read(impact, at)) : Json(nullptr));
  return elements;
}

/// Writes a quantity below `node`; `path` is the part of its key and `open` are the indices that are left.
/// Arrays around it are there already.
template <class Impact>
void put(Json& node, std::string_view path, Place<Impact>& place, std::span<Index> open) {
  if (path == "[]") {
    node = array(place, open[0]);
  } else if (path.starts_with("[]")) {
    path.remove_prefix(path[2] == '.' ? 3 : 2);
    for (open[0] = 0; open[0] < std::ssize(node); ++open[0]) put(node[open[0]], path, place, open.subspan(1));
  } else if (const auto end = path.find_first_of(".["); end != path.npos) {
    put(node[std::string(path.substr(0, end))], path.substr(path[end] == '.' ? end + 1 : end), place, open);
  } else {
    const auto value = place.quantity.read(place.impact, place.at);
    if (!std::holds_alternative<impact::Omitted>(value))
      node[std::string(path)] = std::visit(AsJson(), value);
  }
}

Json law(const contact::Law& law) {
  Json object = {{"law", name(law)}};
  for (const auto& parameter : parameters(law)) object[std::string(parameter.key)] = parameter.value;
  return object;
}

Json chain(const model::Chain& chain) {
  return {{"mass", chain.mass},       {"velocity", chain.velocity},
          {"gap", chain.gap},         {"contact", list(chain.law, law)},
          {"gravity", chain.gravity}, {"precompressed", chain.precompressed}};
}

Json term(const Term& term) {
  return Json::array({term.dof, term.coefficient});
}

Json network(const model::Network& network) {
  Json contacts = Json::array();
  for (std::size_t j = 0; j < network.law.size(); ++j) {
    contacts.push_back(law(network.law[j]));
    contacts.back()["gap"] = network.gap[j];
    contacts.back()["direction"] = list(network.direction[j], term);
    if (const auto pair = balls_of(network, static_cast<Index>(j)))
      contacts.back()["balls"] = {pair->left + 1, pair->right + 1};
  }
  return {{"mass", network.mass},
          {"velocity", network.velocity},
          {"dimension", network.dimension},
          {"contact", contacts},
          {"precompressed", network.precompressed}};
}

/// The quantities of the result, and the words that `labels` lists.
template <class Impact>
Json result(const Impact& impact, const scene::Scene& scene, const char* model) {
  Json result = {{"ending", hybrid::name(impact.ending)}, {"title", scene.title}, {"model", model}};
  if (const auto why = reason(impact.ending, impact.message, scene); !why.empty()) result["message"] = why;
  for (const auto& quantity : impact::quantities<Impact>()) {
    Place<Impact> place{impact, quantity};
    put(result, quantity.is.key, place, place.at);
  }
  result["skipped"] = Json::object();
  for (const auto& one : impact.skipped) result["skipped"][one.what] = one.why;
  if (!scene.warnings.empty()) result["warnings"] = scene.warnings;
  result["provenance"] = provenance_json(scene.sha256);
  return result;
}

Json described(const scene::Scene& scene, const char* model, const Json& numbers) {
  Json result = {{"title", scene.title}, {"model", model}, {model, numbers}};
  if (!scene.radius.empty()) result[model]["radius"] = scene.radius;
  result["run"] = options(scene.run);
  if (!scene.warnings.empty()) result["warnings"] = scene.warnings;
  result["provenance"] = provenance_json(scene.sha256);
  return result;
}

}  // namespace

Json json(const impact::ChainImpact& impact, const scene::Scene& scene) {
  return result(impact, scene, "chain");
}

Json json(const impact::NetworkImpact& impact, const scene::Scene& scene) {
  return result(impact, scene, "network");
}

Json json(const impact::MicrobodyImpact& impact, const scene::Scene& scene) {
  return result(impact, scene, "microbody");
}

Json json(const scene::Scene& scene) {
  return std::visit(
      Overload{[&](const model::Chain& one) { return described(scene, "chain", chain(one)); },
               [&](const model::Network& one) { return described(scene, "network", network(one)); },
               [&](const model::Microbody& one) { return json_of_body(one, scene); },
               [](const scene::LawAlone& nothing) -> Json { scene::refuse(nothing); }},
      scene.model);
}

}  // namespace mariotte::report
