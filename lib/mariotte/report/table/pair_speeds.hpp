// With which speeds a pair came and went, in words.
#pragma once
#include <string>

#include "mariotte/impact/chain/chain_impact.hpp"

namespace mariotte::report {

/// Speeds of approach and separation and their ratio; "" unless the two have met once, in flight, and parted.
std::string pair_table(const impact::MeetingSpeeds& speeds, std::size_t periods);

}  // namespace mariotte::report
