// Results and scenes for people: aligned text with units, at most 100 columns wide, long lists left out in
// the middle. Balls and contacts count from 1.
#pragma once
#include <string>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/report/text.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::report {

/// Events, balls, contacts, ratios and balances; in full also validity, flows and what was skipped.
std::string table(const impact::ChainImpact& impact, const scene::Scene& scene,
                  Detail detail = Detail::usual);

/// Events, motion before and after, restitution, impacts, balance; in full as of a chain. Tips count from 1.
std::string table(const impact::MicrobodyImpact& impact, const scene::Scene& scene,
                  Detail detail = Detail::usual);

/// As of a chain, with the direction of all impulses instead of ratios.
std::string table(const impact::NetworkImpact& impact, const scene::Scene& scene,
                  Detail detail = Detail::usual);

/// Events, bodies, contacts, balances; in full as of a chain.
std::string table(const impact::BodiesImpact& impact, const scene::Scene& scene,
                  Detail detail = Detail::usual);

/// "3 balls and 1 wall".
std::string size_of(const model::Chain& chain);

/// The scene as it was understood, in SI units without prefixes.
std::string table(const scene::Scene& scene);
std::string table_of_body(const model::Microbody& body, const scene::Scene& scene);
std::string table_of_bodies(const model::Bodies& bodies, const scene::Scene& scene);

}  // namespace mariotte::report
