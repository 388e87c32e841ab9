// Networks as the flows see them that need more than a field: as a row of bodies, or as linked freedoms.
#pragma once
#include "mariotte/flow/linked_phase.hpp"
#include "mariotte/flow/serial_phase.hpp"
#include "mariotte/model/network/network_layout.hpp"

namespace mariotte::model {

/// By contact, its place from left to right, if the contacts join bodies of one freedom each in a single row:
/// −1 in the left one, +1 in the right one, and nothing else pushed. Empty otherwise.
std::vector<Index> places_in_row(const DimensionlessNetwork& network);

/// The row as such, with all contacts open.
flow::SerialPhase make_serial(const DimensionlessNetwork& network, const NetworkLayout& layout,
                              const std::vector<Index>& places);

/// The network as such, with all contacts open; it must outlive the phase.
flow::LinkedPhase make_linked(const DimensionlessNetwork& network, const NetworkLayout& layout);

}  // namespace mariotte::model
