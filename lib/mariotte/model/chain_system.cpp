#include "mariotte/model/chain_system.hpp"

#include <algorithm>

namespace mariotte::model {

using contact::ContactMode;

namespace {

void change(ChainSystem::Mode& mode, Index j, ContactMode after, std::vector<ContactChange>& changes) {
  if (mode[j] == after) return;
  changes.push_back({j, mode[j], after});
  mode[j] = after;
}

}  // namespace

ChainSystem::ChainSystem(const Chain& source, double accuracy, bool stay)
    : chain(make_dimensionless(source, accuracy)),
      layout(make_layout(chain)),
      guards_(make_guards(layout)),
      phase_(chain, layout),
      stay_(stay) {}

double ChainSystem::approach(ConstState x, Index j) const {
  return x[layout.velocity[j]] - x[layout.velocity[j + 1]];
}

bool ChainSystem::rests(const Mode& mode, ConstState x, Index j) const {
  return mode[j] == ContactMode::open && x[layout.gap[j]] == 0 && approach(x, j) == 0;
}

/// Touching neighbours at rest are pressed in the same instant, δ ~ t^{7/2} [theory page, "Touching at
/// rest"].
void ChainSystem::press_row(Mode& mode, ConstState x, Index from, std::vector<Change>& changes) const {
  for (Index j = from + 1; j < layout.contacts() && rests(mode, x, j); ++j)
    change(mode, j, ContactMode::touching, changes);
  for (Index j = from - 1; j >= 0 && rests(mode, x, j); --j) change(mode, j, ContactMode::touching, changes);
}

ChainSystem::Mode ChainSystem::mode_at(ConstState x, std::vector<Change>& changes) const {
  Mode mode(layout.contacts(), ContactMode::open);
  for (Index j = 0; j < layout.contacts(); ++j) {
    const double gap = x[layout.gap[j]], speed = approach(x, j);
    const bool driven = speed == 0 && chain.gravity[j + 1] > chain.gravity[j];
    if (gap > 0) continue;
    if (gap < 0) {
      const bool pulls = guards_.load[j] != ChainLayout::absent && load(chain.law[j], -gap, speed) <= 0;
      change(mode, j, pulls ? ContactMode::slack : ContactMode::closed, changes);
    } else if (speed > 0) {
      change(mode, j, ContactMode::closed, changes);
    } else if (driven) {
      change(mode, j, ContactMode::touching, changes);
    }
  }
  for (Index j = 0; j < layout.contacts(); ++j)
    if (contact::carries_force(mode[j])) press_row(mode, x, j, changes);
  return mode;
}

ContactMode ChainSystem::after(ContactMode mode, bool load_fired, double gap, double approach) const {
  switch (mode) {
    case ContactMode::open:
      return approach > chain.slow ? ContactMode::closed : ContactMode::hovering;
    case ContactMode::hovering:
      return ContactMode::closed;
    case ContactMode::slack:
      return load_fired ? ContactMode::closed : ContactMode::open;
    case ContactMode::closed:
      return load_fired && gap < 0 ? ContactMode::slack : ContactMode::open;
    case ContactMode::touching:
      return ContactMode::touching;
  }
  return mode;
}

void ChainSystem::transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                             std::vector<Change>& changes) const {
  for (const Index guard : fired) {
    const Index j = guards_.contact[guard];
    change(mode, j, after(mode[j], guard != j, x[layout.gap[j]], approach(x, j)), changes);
    if (mode[j] == ContactMode::closed) press_row(mode, x, j, changes);
  }
  for (Index j = 0; j < layout.contacts(); ++j)
    if (mode[j] == ContactMode::closed && has_faded(chain, layout, x, j))
      change(mode, j, ContactMode::hovering, changes);
}

bool ChainSystem::is_over(const Mode& mode, ConstState x, bool impacted) const {
  if (chain.falls_back && (stay_ || !impacted)) return false;
  for (Index j = 0; j < layout.contacts(); ++j)
    if (mode[j] == ContactMode::closed || approach(x, j) > chain.slow) return false;
  return true;
}

void ChainSystem::finish(Mode& mode, std::vector<Change>& changes) const {
  for (Index j = 0; j < layout.contacts(); ++j)
    if (mode[j] == ContactMode::touching) change(mode, j, ContactMode::open, changes);
}

ChainPhase& ChainSystem::problem(Mode& mode) {
  phase_.bind(mode);
  return phase_;
}

}  // namespace mariotte::model
