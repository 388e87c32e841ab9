// Results and scenes as JSON, for scripts. Keys and their meaning: doc/result_format.md.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::report {

using Json = nlohmann::ordered_json;

class JsonStream;

/// The result of a run: every quantity of its list (impact/quantities), and the words of `labels`; `more` has
/// further members, and some of its provenance.
void write(JsonStream& out, const impact::ChainImpact& impact, const scene::Scene& scene,
           const Json& more = Json::object());
void write(JsonStream& out, const impact::NetworkImpact& impact, const scene::Scene& scene,
           const Json& more = Json::object());
void write(JsonStream& out, const impact::MicrobodyImpact& impact, const scene::Scene& scene,
           const Json& more = Json::object());
void write(JsonStream& out, const impact::BodiesImpact& impact, const scene::Scene& scene,
           const Json& more = Json::object());

/// The same as a tree, for results that are not large.
Json json(const impact::ChainImpact& impact, const scene::Scene& scene);
Json json(const impact::NetworkImpact& impact, const scene::Scene& scene);
Json json(const impact::MicrobodyImpact& impact, const scene::Scene& scene);
Json json(const impact::BodiesImpact& impact, const scene::Scene& scene);

/// The scene as it was understood. An infinite mass, radius or limit is null.
Json json(const scene::Scene& scene);

/// Text as a JsonStream writes it.
std::string text(const Json& json);

}  // namespace mariotte::report
