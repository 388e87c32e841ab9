// Contacts that link the dofs of a system in any way, seen as what they are.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "mariotte/core/contact_direction.hpp"
#include "mariotte/flow/phase_contact.hpp"

namespace mariotte::flow {

/// δ̈_j = Σ weight_i f_near(i) + outside forces, over first[j] ≤ i < first[j+1]: the matrix −G M⁻¹ Gᵀ by rows.
struct Coupling {
  std::vector<int> first = {0}, near;
  std::vector<double> weight;

  void clear() {
    first.assign(1, 0);
    near.clear();
    weight.clear();
  }
  /// One term more of the last row, which `end_row` completes.
  void add(Index contact, double by_force) {
    near.push_back(static_cast<int>(contact));
    weight.push_back(by_force);
  }
  void end_row() { first.push_back(static_cast<int>(near.size())); }
};

/// A phase of n dofs whose velocities are the first n components of the state, M v̇ = Gᵀ f, ġ = G v. The
/// spans hold one entry per contact.
struct LinkedPhase {
  std::vector<PhaseContact> contact;
  Index dofs = 0;
  std::span<const ContactDirection> direction;      ///< rows of G
  std::span<const ContactDirection> response;       ///< columns of M⁻¹ Gᵀ
  std::span<const ContactDirection> half_response;  ///< columns of L⁻¹ Gᵀ, M = L Lᵀ
  Coupling coupling;
  double speed = 1;          ///< natural relative speed
  double reached_speed = 1;  ///< of it what dampers do not hold back: what rounding of rates is relative to
  double fade_speed = 0;     ///< rate at which a contact fades that is less deep than its faded()
};

/// Other links may draw apart what touches at rest. Until it has left the noise its smooth force would pull
/// then, by c δⁿ: too much where damping is strong.
inline bool may_pull(const PhaseContact& contact, double speed) {
  return contact.role == Role::touching && contact.damping_share(speed) > 0.5;
}
inline bool may_pull(const LinkedPhase& phase) {
  return std::any_of(phase.contact.begin(), phase.contact.end(),
                     [&](const PhaseContact& c) { return may_pull(c, phase.speed); });
}

}  // namespace mariotte::flow
