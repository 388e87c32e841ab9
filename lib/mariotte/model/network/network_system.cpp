#include "mariotte/model/network/network_system.hpp"

#include <cmath>

namespace mariotte::model {

using contact::ContactMode;

NetworkSystem::NetworkSystem(const Network& network, double accuracy)
    : network_(make_dimensionless(network, accuracy)),
      layout_(make_layout(network_)),
      phase_(network_, layout_) {}

bool NetworkSystem::rests(const Mode& mode, ConstState x, Index j) const {
  // Gap rates are sums of products of velocities: equal velocities leave rounding.
  return mode[j] == ContactMode::open && x[layout_.gap(j)] == 0 &&
         std::abs(phase_.approach(x, j)) <= 8 * epsilon * network_.speed;
}

void NetworkSystem::press_near(Mode& mode, ConstState x, Index from, std::vector<Change>& changes) const {
  std::vector<Index> pressed = {from};
  while (!pressed.empty()) {
    const Index j = pressed.back();
    pressed.pop_back();
    for (const Index near : network_.near[j]) {
      if (!rests(mode, x, near)) continue;
      change(mode, near, ContactMode::touching, changes);
      pressed.push_back(near);
    }
  }
}

void NetworkSystem::mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const {
  mode.assign(layout_.contacts, ContactMode::open);
  for (Index j = 0; j < layout_.contacts; ++j) {
    const double gap = x[layout_.gap(j)], speed = phase_.approach(x, j);
    if (gap > 0 || (gap == 0 && speed <= 0) || rests(mode, x, j)) continue;
    const bool damped = layout_.work[j] != NetworkLayout::absent;
    const bool pulls = gap < 0 && damped && load(network_.law[j], -gap, speed).value <= 0;
    change(mode, j, pulls ? ContactMode::slack : ContactMode::closed, changes);
  }
  for (Index j = 0; j < layout_.contacts; ++j)
    if (mode[j] == ContactMode::closed) press_near(mode, x, j, changes);
}

void NetworkSystem::transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                               std::vector<Change>& changes) const {
  for (const Index guard : fired) {
    const Index j = layout_.guard_contact[guard];
    const auto after =
        mode_after(mode[j], guard != j, x[layout_.gap(j)], phase_.approach(x, j), network_.slow);
    change(mode, j, after, changes);
    if (mode[j] == ContactMode::closed) press_near(mode, x, j, changes);
  }
  for (Index j = 0; j < layout_.contacts; ++j) {
    if (phase_.has_faded(x, j)) change(mode, j, ContactMode::hovering, changes);
    if (phase_.has_parted(x, j)) change(mode, j, ContactMode::open, changes);
  }
}

bool NetworkSystem::is_over(const Mode& mode, ConstState x, bool) const {
  for (Index j = 0; j < layout_.contacts; ++j)
    if (mode[j] == ContactMode::closed || phase_.approach(x, j) > network_.slow) return false;
  return true;
}

void NetworkSystem::finish(Mode& mode, std::vector<Change>& changes) const {
  open_touching(mode, changes);
}

NetworkPhase& NetworkSystem::problem(Mode& mode) {
  phase_.bind(mode);
  return phase_;
}

}  // namespace mariotte::model
