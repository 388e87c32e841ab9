#include "mariotte/model/chain/chain_system.hpp"

#include <algorithm>

namespace mariotte::model {

using contact::ContactMode;

void ChainSystem::reset(const Chain& chain, double accuracy, bool stay) {
  make_dimensionless(chain, accuracy, chain_);
  make_layout(chain_, layout_);
  make_guards(layout_, guards_);
  phase_.reset();
  stay_ = stay;
}

void ChainSystem::reset(const DimensionlessChain& whole, Index first, Index last, Index margin) {
  copy_slice(whole, first, last, chain_);
  make_layout(chain_, layout_);
  make_guards(layout_, guards_);
  phase_.reset();
  phase_.set_edges(
      {.left = first > 0, .right = last + 1 < static_cast<Index>(whole.mass.size()), .margin = margin});
  stay_ = true;
}

void ChainSystem::mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const {
  contact_set_at(state(x), mode, changes);
}

void ChainSystem::transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                             std::vector<Change>& changes) const {
  for (const Index guard : fired) {
    const Index j = guards_.contact[guard];
    change(mode, j, after(state(x), j, mode[j], guard != j), changes);
    if (mode[j] == ContactMode::closed) press_row(state(x), mode, j, changes);
  }
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (mode[j] == ContactMode::slack && is_loaded_again(state(x), mode, j))
      change(mode, j, ContactMode::closed, changes);
  const auto has_fired = [&](Index j) {
    return std::any_of(fired.begin(), fired.end(), [&](Index guard) { return guards_.contact[guard] == j; });
  };
  for (Index j = 0; j < layout_.contacts(); ++j) {
    if (mode[j] == ContactMode::closed && has_faded(chain_, layout_, x, j) && !has_fired(j))
      change(mode, j, ContactMode::hovering, changes);
    if (mode[j] == ContactMode::touching && has_loaded(chain_, layout_, x, j))
      mode[j] = ContactMode::closed;  // no event
  }
}

bool ChainSystem::is_over(const Mode& mode, ConstState x, bool impacted) const {
  if (chain_.falls_back && (stay_ || !impacted)) return false;
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (mode[j] == ContactMode::closed || comes_together(chain_, j, state(x).approach(j))) return false;
  return true;
}

void ChainSystem::finish(Mode& mode, std::vector<Change>& changes) const {
  open_touching(mode, changes);
}

ChainPhase& ChainSystem::problem(Mode& mode) {
  phase_.bind(mode);
  return phase_;
}

}  // namespace mariotte::model
