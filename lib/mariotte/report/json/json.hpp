// Results and scenes as JSON, for scripts. Keys and meaning: doc/interface of the command; SI units
// throughout.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::report {

using Json = nlohmann::ordered_json;

/// The result of a run. Arrays count from 0 by position; the contacts named in `events` count from 1.
/// Undefined ratios, periods that have not ended and an accuracy that was not estimated are null.
Json json(const impact::ChainImpact& impact, const scene::Scene& scene);

/// The same of a body: tips count from 1 in `events` and `impacts`; a `force_sign` of 1 says that the force
/// on tip 1 turns into a push, −1 into a pull.
Json json(const impact::MicrobodyImpact& impact, const scene::Scene& scene);

/// As of a chain; of the momentum only the residual is told.
Json json(const impact::NetworkImpact& impact, const scene::Scene& scene);

/// The scene as it was understood. An infinite mass, radius or limit is null.
Json json(const scene::Scene& scene);

/// Text with one top-level key per line and 17 significant digits; numbers that are not finite become null
/// and bytes that are not UTF-8 are replaced, so that the text is always valid JSON. Ends with a newline.
std::string text(const Json& json);

}  // namespace mariotte::report
