// Contacts linked in any way in the window: all of them.
#include <cmath>

#include "mariotte/flow/taylor/window_parts.hpp"

namespace mariotte::flow::taylor {
namespace {

/// Rates are sums of products: what touches at rest has the rounding of zero.
double settled_rate(const LinkedPhase& phase, ConstState x, Index j) {
  const double rate = -gap_rate(phase.direction[j], x);
  const bool rests = phase.contact[j].role == Role::touching && std::abs(rate) <= 8 * epsilon * phase.speed;
  return rests ? 0 : rate;
}

}  // namespace

void place(Window& w, const LinkedPhase& phase, State x, double time) {
  w.row = nullptr;
  w.network = &phase;
  w.speed = phase.speed;
  w.fade_speed = phase.fade_speed;
  w.x = x;
  w.since = w.time = time;
  begin(w, phase.contact);
  auto& l = w.lanes;
  for (int lane = 0; lane < l.count; ++lane) {
    l.left[lane] = -phase.coupling.weight[phase.coupling.first[lane]];  // of the contact itself
    l.right[lane] = l.drive[lane] = 0;
    fill(w, lane, settled_rate(phase, x, lane));
  }
  w.velocity.assign(x.begin(), x.begin() + phase.dofs);
  link(w, phase.coupling);
  settle(w);
}

}  // namespace mariotte::flow::taylor
