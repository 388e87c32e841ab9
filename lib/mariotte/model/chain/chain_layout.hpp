// The layout of a chain's state.
#pragma once
#include "mariotte/model/chain/dimensionless_chain.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"

namespace mariotte::model {

using ChainLayout = ContactLayout;

/// The state runs along the chain, v_1 g_1 v_2 g_2 … v_n, so that the Jacobian is a narrow band; work and
/// impulse stand behind the gap. Momentum tells the impulses of all contacts but faint ones and those with a
/// wall. Reuses the layout's memory.
void make_layout(const DimensionlessChain& chain, ChainLayout& layout);

}  // namespace mariotte::model
