#include "mariotte/model/chain/chain_modes.hpp"

namespace mariotte::model {

using contact::ContactMode;
using contact::ContactSet;

bool comes_together(const DimensionlessChain& chain, Index j, double approach) {
  const bool pulled = chain.gravity[j + 1] > chain.gravity[j];
  return approach > (pulled ? -chain.slow : chain.slow);
}

ContactMode after(const ChainState& state, Index j, ContactMode before, bool load_fired) {
  return mode_after(before, load_fired, state.gap(j), state.approach(j), state.chain.slow);
}

bool is_loaded_again(const ChainState& state, const ContactSet& mode, Index j) {
  const auto& chain = state.chain;
  const double rate = state.approach(j);
  const auto own = load(chain.law[j], -state.gap(j), rate);
  if (!(own.value > 0)) return false;
  const auto force = [&](Index i) {
    if (i < 0 || i == state.layout.contacts()) return 0.0;
    return force_in(mode[i], chain.law[i], -state.gap(i), state.approach(i)).value;
  };
  const double bend = chain.inverse_mass[j] * force(j - 1) - chain.gravity[j] +
                      chain.inverse_mass[j + 1] * force(j + 1) + chain.gravity[j + 1];
  return own.by_indentation * rate + own.by_rate * bend > 0;
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
      const bool pulls = contact::dissipates(chain.law[j]) && load(chain.law[j], -gap, speed).value <= 0;
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

}  // namespace mariotte::model
