#include "mariotte/report/json/json.hpp"

#include "mariotte/core/overload.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/reason.hpp"

namespace mariotte::report {
namespace {

Json period(const impact::Period& period) {
  return Json::array({period.start, nullable(period.end)});
}

Json contact_history(const impact::ContactHistory& contact) {
  return {{"impulse", contact.impulse},
          {"peak_force", contact.peak_force},
          {"peak_indentation", contact.peak_indentation},
          {"periods", list(contact.periods, period)},
          {"stored", contact.stored},
          {"dissipated", contact.dissipated}};
}

// Every model names the same five changes; balls on a line neither stick, slip nor get captured.
Json event(const impact::Event& event) {
  return {{"time", event.time},     {"open", from_one(event.open)}, {"close", from_one(event.close)},
          {"stick", Json::array()}, {"slip", Json::array()},        {"capture", Json::array()}};
}

Json energy(const impact::EnergyLedger& ledger) {
  return {{"initial", ledger.initial},
          {"final", ledger.final},
          {"stored", ledger.stored},
          {"dissipated", ledger.dissipated},
          {"work", ledger.work},
          {"residual", ledger.residual},
          {"ratio_lab", nullable(ledger.ratio_lab)},
          {"ratio_centre", nullable(ledger.ratio_centre)}};
}

Json momentum(const impact::MomentumLedger& ledger) {
  return {{"initial", ledger.initial}, {"final", ledger.final}, {"residual", ledger.residual}};
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
  return Json::array({term.freedom, term.coefficient});
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

Json result(const impact::ContactImpact& impact, const scene::Scene& scene, const char* model,
            const Json& momentum) {
  Json result = {{"ending", hybrid::name(impact.ending)}, {"title", scene.title}, {"model", model}};
  if (const auto why = reason(impact.ending, impact.message, scene.run); !why.empty())
    result["message"] = why;
  result["final"] = {{"time", impact.time}, {"velocity", impact.velocity}, {"gap", impact.gap}};
  result["contacts"] = list(impact.contacts, contact_history);
  result["icr"] = list(impact.icr, nullable);
  result["impulse_direction"] = impact.impulse_direction;
  result["events"] = list(impact.events, event);
  result["energy"] = energy(impact.energy);
  result["momentum"] = momentum;
  result["accuracy"] = {{"requested", impact.requested_accuracy},
                        {"estimated", nullable(impact.estimated_accuracy)}};
  result["flows"] = list(impact.flows, flow);
  result["skipped"] = skipped(impact.skipped);
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
  return result(impact, scene, "chain", momentum(impact.momentum));
}

Json json(const impact::NetworkImpact& impact, const scene::Scene& scene) {
  return result(impact, scene, "network", {{"residual", impact.momentum_residual}});
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
