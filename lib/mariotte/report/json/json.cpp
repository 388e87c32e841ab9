#include "mariotte/report/json/json.hpp"

#include <array>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/report/json/json_parts.hpp"
#include "mariotte/report/json/quantity_json.hpp"
#include "mariotte/report/reason.hpp"
#include "mariotte/report/warnings.hpp"

namespace mariotte::report {
namespace {

Json term(const Term& term) {
  return Json::array({term.dof, term.coefficient});
}

Json drive(const model::Drive& drive) {
  const auto piece = [](const SignalPiece& p) -> Json {
    return {{"start", p.start},
            {"amplitude", p.amplitude},
            {"angular_frequency", p.frequency},
            {"phase", p.phase},
            {"powers", p.power}};
  };
  constexpr std::array quantities{"position", "velocity", "force"};
  return {{"quantity", quantities[static_cast<std::size_t>(drive.quantity)]},
          {"direction", list(drive.direction, term)},
          {"signal", list(drive.signal.piece, piece)}};
}

Json with_drives(Json model, const std::vector<model::Drive>& drives) {
  if (!drives.empty()) model["drive"] = list(drives, drive);
  return model;
}

Json chain(const model::Chain& chain) {
  return with_drives({{"mass", chain.mass},
                      {"velocity", chain.velocity},
                      {"gap", chain.gap},
                      {"contact", list(chain.law, law_json)},
                      {"gravity", chain.gravity},
                      {"precompressed", chain.precompressed}},
                     chain.drive);
}

Json network(const model::Network& network) {
  Json contacts = Json::array();
  for (std::size_t j = 0; j < network.law.size(); ++j) {
    contacts.push_back(law_json(network.law[j]));
    contacts.back()["gap"] = network.gap[j];
    contacts.back()["direction"] = list(network.direction[j], term);
    if (const auto pair = balls_of(network, static_cast<Index>(j)))
      contacts.back()["balls"] = {pair->left + 1, pair->right + 1};
  }
  return with_drives({{"mass", network.mass},
                      {"velocity", network.velocity},
                      {"dimension", network.dimension},
                      {"contact", contacts},
                      {"precompressed", network.precompressed}},
                     network.drive);
}

/// Suspicious values of the scene, and what has to be said of the result.
template <class Impact>
std::vector<std::string> all_warnings(const Impact& impact, const scene::Scene& scene) {
  auto list = scene.warnings;
  for (auto& one : warnings(impact, scene.run.flow)) list.push_back(std::move(one));
  return list;
}

Json skipped(const std::vector<impact::Skipped>& list) {
  Json result = Json::object();
  for (const auto& one : list) result[one.what] = one.why;
  return result;
}

/// The quantities of the result, and the words that `labels` lists.
template <class Impact>
void result(JsonStream& out, const Impact& impact, const scene::Scene& scene, const Json& more,
            const char* model) {
  static const QuantityTree<Impact> tree;
  const auto member = [&](std::string_view key, const Json& value) {
    out.key(key);
    out.value(value);
  };
  out.open_object();
  member("ending", hybrid::name(impact.ending));
  member("title", scene.title);
  member("model", model);
  if (const auto why = reason(impact.ending, impact.message, scene); !why.empty()) member("message", why);
  tree.write(impact, out);
  member("skipped", skipped(impact.skipped));
  if (const auto all = all_warnings(impact, scene); !all.empty()) member("warnings", all);
  auto provenance = provenance_json(scene.sha256);
  provenance.update(more.value("provenance", Json::object()));
  member("provenance", provenance);
  for (const auto& [key, value] : more.items())
    if (key != "provenance") member(key, value);
  out.close();
}

template <class Impact>
Json parsed(const Impact& impact, const scene::Scene& scene) {
  std::string all;
  JsonStream stream([&](std::string_view piece) { all += piece; });
  write(stream, impact, scene);
  return Json::parse(all);
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

Json law_json(const contact::Law& law) {
  Json object = {{"law", name(law)}};
  for (const auto& parameter : parameters(law)) object[std::string(parameter.key)] = parameter.value;
  if (contact::is_uncut(law)) object["separation"] = "indentation";
  return object;
}

void write(JsonStream& out, const impact::ChainImpact& impact, const scene::Scene& scene, const Json& more) {
  result(out, impact, scene, more, "chain");
}
void write(JsonStream& out, const impact::NetworkImpact& impact, const scene::Scene& scene,
           const Json& more) {
  result(out, impact, scene, more, "network");
}
void write(JsonStream& out, const impact::MicrobodyImpact& impact, const scene::Scene& scene,
           const Json& more) {
  result(out, impact, scene, more, "microbody");
}

void write(JsonStream& out, const impact::BodiesImpact& impact, const scene::Scene& scene, const Json& more) {
  result(out, impact, scene, more, "bodies");
}

Json json(const impact::BodiesImpact& impact, const scene::Scene& scene) {
  return parsed(impact, scene);
}
Json json(const impact::ChainImpact& impact, const scene::Scene& scene) {
  return parsed(impact, scene);
}
Json json(const impact::NetworkImpact& impact, const scene::Scene& scene) {
  return parsed(impact, scene);
}
Json json(const impact::MicrobodyImpact& impact, const scene::Scene& scene) {
  return parsed(impact, scene);
}

Json json(const scene::Scene& scene) {
  return std::visit(
      Overload{[&](const model::Chain& one) { return described(scene, "chain", chain(one)); },
               [&](const model::Network& one) { return described(scene, "network", network(one)); },
               [&](const model::Microbody& one) { return json_of_body(one, scene); },
               [&](const model::Bodies& one) { return json_of_bodies(one, scene); },
               [](const scene::LawAlone& nothing) -> Json { scene::refuse(nothing); }},
      scene.model);
}

}  // namespace mariotte::report
