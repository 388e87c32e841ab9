// What has to be said of a result beside its numbers, as sentences.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/flow/kind.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"

namespace mariotte::report {

/// That the promise of an accuracy could not be kept; that another flow followed it than was `asked` for;
/// that nothing collides, which is a slip more often than wanted; and one for each number of the validity
/// beyond its limit: "contact 3: max a/R = 0.31 is above 0.1: strains are …".
std::vector<std::string> warnings(const impact::ContactImpact& impact, std::optional<flow::Kind> asked);
/// Of a network of balls also which of them will pass through each other.
std::vector<std::string> warnings(const impact::NetworkImpact& impact, std::optional<flow::Kind> asked);
std::vector<std::string> warnings(const impact::BodiesImpact& impact, std::optional<flow::Kind> asked);
std::vector<std::string> warnings(const impact::MicrobodyImpact& impact, std::optional<flow::Kind> asked);

}  // namespace mariotte::report
