#include "mariotte/model/chain_modes.hpp"

#include "mariotte/model/chain_phase.hpp"

namespace mariotte::model {

using contact::ContactMode;
using contact::ContactSet;

void change(ContactSet& mode, Index j, ContactMode after, std::vector<ContactChange>& changes) {
  if (mode[j] == after) return;
  changes.push_back({j, mode[j], after});
  mode[j] = after;
}

ContactMode after(const ChainState& state, Index j, ContactMode before, bool load_fired) {
  switch (before) {
    case ContactMode::open:
      return state.approach(j) > state.chain.slow ? ContactMode::closed : ContactMode::hovering;
    case ContactMode::hovering:
      return ContactMode::closed;
    case ContactMode::slack:
      return load_fired ? ContactMode::closed : ContactMode::open;
    case ContactMode::closed:
      return load_fired && state.gap(j) < 0 ? ContactMode::slack : ContactMode::open;
    case ContactMode::touching:
      return ContactMode::open;
  }
  return before;
}

bool rests(const ChainState& state, ContactMode mode, Index j) {
  return mode == ContactMode::open && state.gap(j) == 0 && state.approach(j) == 0;
}

void press_row(const ChainState& state, ContactSet& mode, Index from, std::vector<ContactChange>& changes) {
  for (Index j = from + 1; j < state.layout.contacts() && rests(state, mode[j], j); ++j)
    change(mode, j, ContactMode::touching, changes);
  for (Index j = from - 1; j >= 0 && rests(state, mode[j], j); --j)
    change(mode, j, ContactMode::touching, changes);
}

void contact_set_at(const ChainState& state, ContactSet& mode, std::vector<ContactChange>& changes) {
  const auto& chain = state.chain;
  mode.assign(state.layout.contacts(), ContactMode::open);
  for (Index j = 0; j < state.layout.contacts(); ++j) {
    const double gap = state.gap(j), speed = state.approach(j);
    const bool driven = speed == 0 && chain.gravity[j + 1] > chain.gravity[j];
    if (gap > 0) continue;
    if (gap < 0) {
      const bool pulls = contact::damping(chain.law[j]) > 0 && load(chain.law[j], -gap, speed) <= 0;
      change(mode, j, pulls ? ContactMode::slack : ContactMode::closed, changes);
    } else if (speed > 0) {
      change(mode, j, ContactMode::closed, changes);
    } else if (driven) {
      change(mode, j, ContactMode::touching, changes);
    }
  }
  for (Index j = 0; j < state.layout.contacts(); ++j)
    if (contact::carries_force(mode[j])) press_row(state, mode, j, changes);
}

void open_touching(ContactSet& mode, std::vector<ContactChange>& changes) {
  for (Index j = 0; j < static_cast<Index>(mode.size()); ++j)
    if (mode[j] == ContactMode::touching) change(mode, j, ContactMode::open, changes);
}

}  // namespace mariotte::model
