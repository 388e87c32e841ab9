// Parts of tables that are about networks alone.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/network/network_impact.hpp"

namespace mariotte::report {

/// "16 balls in the plane, 33 contacts".
std::string size_of(const model::Network& network);

/// Velocities before and after: of balls by coordinate, of other dofs as they are, in SI.
std::string motion_table(const model::Network& network, const std::vector<double>& after);

/// "1–2" of each contact of balls; empty for other networks.
std::vector<std::string> contact_names(const model::Network& network);

/// By how much directions of contacts would have turned; empty for other networks.
std::string neglected_table(const impact::NetworkImpact& impact);

/// r = p/|p|, unless no impulse was exchanged.
std::string direction_table(const impact::ContactImpact& impact);

}  // namespace mariotte::report
