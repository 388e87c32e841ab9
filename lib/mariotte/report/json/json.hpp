// Results and scenes as JSON, for scripts. Keys and their meaning: doc/result_format.md.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::report {

using Json = nlohmann::ordered_json;

/// The result of a run: every quantity of its list (impact/quantities), and the words of `labels`.
Json json(const impact::ChainImpact& impact, const scene::Scene& scene);
Json json(const impact::NetworkImpact& impact, const scene::Scene& scene);
Json json(const impact::MicrobodyImpact& impact, const scene::Scene& scene);

/// The scene as it was understood. An infinite mass, radius or limit is null.
Json json(const scene::Scene& scene);

/// Text with one top-level key per line and 17 significant digits; numbers that are not finite become null
/// and bytes that are not UTF-8 are replaced, so that the text is always valid JSON. Ends with a newline.
std::string text(const Json& json);

}  // namespace mariotte::report
