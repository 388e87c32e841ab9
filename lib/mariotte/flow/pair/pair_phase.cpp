#include "mariotte/flow/pair/pair_phase.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow {
namespace {

/// The one contact that is not open, if it is closed; else −1.
Index only_closed(const SerialPhase& phase) {
  Index found = -1;
  for (std::size_t j = 0; j < phase.contact.size(); ++j) {
    const auto role = phase.contact[j].role;
    if (role == Role::open) continue;
    if (role != Role::closed || found >= 0) return -1;
    found = static_cast<Index>(j);
  }
  return found;
}

/// Where a contact pulls, other gaps may close at any time: it must be the only one.
bool has_closed_form(const SerialPhase& phase, const PhaseContact& c) {
  if (has_acceleration(phase)) return false;
  if (c.width) return c.width->damping == 0 && phase.contact.size() == 1;
  if (c.pull != 0 || c.ring != 0) return false;
  return c.is_linear() || (c.exponent == 1.5 && c.damping == 0);
}

}  // namespace

std::optional<PairPhase> find_pair(const SerialPhase& phase) {
  const Index j = only_closed(phase);
  if (j < 0 || !has_closed_form(phase, phase.contact[j])) return std::nullopt;
  const auto& c = phase.contact[j];
  const auto &left = phase.body[j], &right = phase.body[j + 1];
  const auto* before = j > 0 ? &phase.contact[j - 1] : nullptr;
  const auto* after = j + 1 < std::ssize(phase.contact) ? &phase.contact[j + 1] : nullptr;
  const double mass = 1 / (left.inverse_mass + right.inverse_mass);
  return PairPhase{.law = {c.stiffness, c.damping, c.exponent, mass, c.width},
                   .contact = &c,
                   .left_share = mass * left.inverse_mass,
                   .right_share = mass * right.inverse_mass,
                   .left = left.velocity,
                   .right = right.velocity,
                   .guard = c.damping > 0 ? c.load_guard : c.guard,
                   .yield_speed = std::max(c.turn_speed, 4 * std::sqrt(epsilon) * phase.speed),
                   .left_gap = before ? before->gap : -1,
                   .right_gap = after ? after->gap : -1,
                   .left_guard = before ? before->guard : -1,
                   .right_guard = after ? after->guard : -1};
}

}  // namespace mariotte::flow
