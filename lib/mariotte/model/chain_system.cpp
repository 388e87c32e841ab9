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

void ChainSystem::reset(const Chain& chain, double accuracy, bool stay) {
  make_dimensionless(chain, accuracy, chain_);
  make_layout(chain_, layout_);
  make_guards(layout_, guards_);
  phase_.reset();
  stay_ = stay;
}

double ChainSystem::approach(ConstState x, Index j) const {
  return x[layout_.velocity[j]] - x[layout_.velocity[j + 1]];
}

bool ChainSystem::rests(const Mode& mode, ConstState x, Index j) const {
  return mode[j] == ContactMode::open && x[layout_.gap[j]] == 0 && approach(x, j) == 0;
}

/// Touching neighbours at rest are pressed in the same instant, δ ~ t^{7/2} [theory page, "Touching at
/// rest"].
void ChainSystem::press_row(Mode& mode, ConstState x, Index from, std::vector<Change>& changes) const {
  for (Index j = from + 1; j < layout_.contacts() && rests(mode, x, j); ++j)
    change(mode, j, ContactMode::touching, changes);
  for (Index j = from - 1; j >= 0 && rests(mode, x, j); --j) change(mode, j, ContactMode::touching, changes);
}

void ChainSystem::mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const {
  mode.assign(layout_.contacts(), ContactMode::open);
  for (Index j = 0; j < layout_.contacts(); ++j) {
    const double gap = x[layout_.gap[j]], speed = approach(x, j);
    const bool driven = speed == 0 && chain_.gravity[j + 1] > chain_.gravity[j];
    if (gap > 0) continue;
    if (gap < 0) {
      const bool pulls = guards_.load[j] != ChainLayout::absent && load(chain_.law[j], -gap, speed) <= 0;
      change(mode, j, pulls ? ContactMode::slack : ContactMode::closed, changes);
    } else if (speed > 0) {
      change(mode, j, ContactMode::closed, changes);
    } else if (driven) {
      change(mode, j, ContactMode::touching, changes);
    }
  }
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (contact::carries_force(mode[j])) press_row(mode, x, j, changes);
}

ContactMode ChainSystem::after(ContactMode mode, bool load_fired, double gap, double approach) const {
  switch (mode) {
    case ContactMode::open:
      return approach > chain_.slow ? ContactMode::closed : ContactMode::hovering;
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
    change(mode, j, after(mode[j], guard != j, x[layout_.gap[j]], approach(x, j)), changes);
    if (mode[j] == ContactMode::closed) press_row(mode, x, j, changes);
  }
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (mode[j] == ContactMode::closed && has_faded(chain_, layout_, x, j))
      change(mode, j, ContactMode::hovering, changes);
}

bool ChainSystem::is_over(const Mode& mode, ConstState x, bool impacted) const {
  if (chain_.falls_back && (stay_ || !impacted)) return false;
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (mode[j] == ContactMode::closed || approach(x, j) > chain_.slow) return false;
  return true;
}

void ChainSystem::finish(Mode& mode, std::vector<Change>& changes) const {
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (mode[j] == ContactMode::touching) change(mode, j, ContactMode::open, changes);
}

ChainPhase& ChainSystem::problem(Mode& mode) {
  phase_.bind(mode);
  return phase_;
}

}  // namespace mariotte::model
