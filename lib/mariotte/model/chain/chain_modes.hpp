// Which contacts of a chain act, and what comes after a guard has fired.
#pragma once
#include <vector>

#include "mariotte/model/chain/chain_layout.hpp"
#include "mariotte/model/contacts/contact_automaton.hpp"

namespace mariotte::model {

/// A chain, where its quantities stand, and a state.
struct ChainState {
  const DimensionlessChain& chain;
  const ChainLayout& layout;
  ConstState x;

  double gap(Index j) const { return x[layout.gap[j]]; }
  double approach(Index j) const { return x[layout.velocity[j]] - x[layout.velocity[j + 1]]; }
};

/// The balls of contact j approach or, where gravity pulls them together, do not part: they rest on each
/// other or will meet again before they have parted.
bool comes_together(const DimensionlessChain& chain, Index j, double approach);

/// The mode of contact j after its gap, or its load, has fired.
contact::ContactMode after(const ChainState& state, Index j, contact::ContactMode before, bool load_fired);

/// The load of slack contact j is positive and its neighbours' forces let it grow: it pushes again. Where a
/// load has vanished but for rounding, its guard may stand beyond zero already, and would never fire.
bool is_loaded_again(const ChainState& state, const contact::ContactSet& mode, Index j);

/// Touching neighbours at rest are pressed in the same instant as contact `from`, δ ~ t^{7/2} [theory page,
/// "Touching at rest"].
void press_row(const ChainState& state, contact::ContactSet& mode, Index from,
               std::vector<ContactChange>& changes);

/// Contact j of mode `mode` touches at rest.
bool rests(const ChainState& state, contact::ContactMode mode, Index j);

/// Contacts that carry force at 0+: indented ones, touching ones that approach or are driven together, and
/// touching ones at rest that stand in a row with one of these.
void contact_set_at(const ChainState& state, contact::ContactSet& mode, std::vector<ContactChange>& changes);

}  // namespace mariotte::model
