// Networks that are rows of bodies, as the flows made for rows see them.
#pragma once
#include "mariotte/flow/serial_phase.hpp"
#include "mariotte/model/network_phase.hpp"

namespace mariotte::model {

/// By contact, its place from left to right, if the contacts join bodies of one freedom each in a single row:
/// −1 in the left one, +1 in the right one, and nothing else pushed. Empty otherwise.
std::vector<Index> places_in_row(const DimensionlessNetwork& network);

/// The row as such, with all contacts open.
void make_serial(const DimensionlessNetwork& network, const NetworkLayout& layout,
                 const std::vector<Index>& places, flow::SerialPhase& phase);

}  // namespace mariotte::model
