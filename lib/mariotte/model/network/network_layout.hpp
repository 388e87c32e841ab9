// The layout of a network's state.
#pragma once
#include "mariotte/model/contacts/contact_layout.hpp"
#include "mariotte/model/network/dimensionless_network.hpp"

namespace mariotte::model {

/// The state is v (n), g (m), P (m), and W of the contacts that dissipate. All impulses are integrated, since
/// momentum does not tell them where contacts are redundant. Reuses the layout's memory.
void make_layout(const DimensionlessNetwork& network, ContactLayout& layout);

}  // namespace mariotte::model
