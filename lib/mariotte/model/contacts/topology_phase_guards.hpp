// The guards of TopologyPhase, members like those in topology_phase_members.hpp.
#pragma once
#include <cmath>

#include "mariotte/model/contacts/topology_phase.hpp"

namespace mariotte::model {

/// A turn is one once the rate is beyond what cannot be told from rest.
template <class Topology>
double TopologyPhase<Topology>::slow_turn(Index j) const {
  const double slow = topology_.model.noise_speed;
  return past(j).recedes ? -slow : slow;
}

/// A slack contact pushes again once its load is clear of what rounding of the velocities makes of it: where
/// it has vanished, that may be positive, and would never rise through zero. A load without δ fades to
/// rounding while its contact pushes, and falls through zero where it is clear of what errors of the rate
/// make of it.
template <class Topology>
double TopologyPhase<Topology>::clear_load(ConstState x, Index j) const {
  const auto own = load(x, j);
  if ((*mode_)[j] != contact::ContactMode::slack)
    return own.by_indentation != 0 ? own.value : own.value + 10 * own.by_rate * topology_.model.noise_speed;
  double size = 0;
  topology_.for_each_direction(j, [&](Index place, double g) { size += std::abs(g * x[place]); });
  return own.value - 16 * epsilon * size * std::abs(own.by_rate);
}

template <class Topology>
double TopologyPhase<Topology>::guard(ConstState x, Index i) const {
  const Index j = at().guard_contact[i];
  switch (at().kind(i)) {
    case GuardKind::kink:
      return x[at().clock] - next_kink(i - at().kink_guard(0));
    case GuardKind::gap:
      return x[at().gap[j]] + level(j);
    case GuardKind::load:
      return clear_load(x, j);
    case GuardKind::yield:
      return -x[at().gap[j]] - contact::branched(law(j))->yield_indentation(past(j));
    case GuardKind::turn:
      return topology_.approach(x, j) + slow_turn(j);
  }
  return 0;
}

template <class Topology>
void TopologyPhase<Topology>::guards(ConstState x, State values) const {
  // A masked guard stands on the side from which it cannot seem to have crossed when it is watched again.
  for (Index i = 0; i < guard_count(); ++i) {
    const auto kind = at().kind(i);
    const double side = kind == GuardKind::load || kind == GuardKind::turn ? 1 : -1;
    values[i] = crossings_[i] == flow::Crossing::none ? side : guard(x, i);
  }
}

template <class Topology>
double TopologyPhase<Topology>::guard_rate(ConstState x, ConstState dx, Index i) const {
  if (at().kind(i) == GuardKind::kink) return 1;
  const Index j = at().guard_contact[i];
  const double widening = dx[at().gap[j]];
  switch (at().kind(i)) {
    case GuardKind::gap:
      return widening;
    case GuardKind::load: {
      const auto own = load(x, j);
      return own.by_rate * topology_.approach(dx, j) - own.by_indentation * widening;
    }
    case GuardKind::yield:
      return -widening;
    case GuardKind::turn:
      return topology_.approach(dx, j);
    case GuardKind::kink:
      break;
  }
  return 0;
}

template <class Topology>
void TopologyPhase<Topology>::guard_rates(ConstState x, ConstState dx, State rates) const {
  for (Index i = 0; i < guard_count(); ++i)
    rates[i] = crossings_[i] == flow::Crossing::none ? 0 : guard_rate(x, dx, i);
}

}  // namespace mariotte::model
