// Bodies in a row, seen as what they are: what the flows that need more than a field are made for.
#pragma once
#include <algorithm>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::flow {

/// A phase of bodies on a line, each with a contact to the next, under constant outside accelerations: where
/// its quantities stand in the state.
struct SerialPhase {
  struct Body {
    Index velocity;
    double inverse_mass;
    double acceleration;
  };
  enum class Role : signed char {
    open,      ///< carries no force; closes where its gap is −level
    closed,    ///< carries force
    touching,  ///< carries force; touched at rest before, and is watched once it has left the noise
    slack      ///< indented without force
  };
  /// Contact j joins bodies j and j+1; f = δ^{n−1} (k δ + c δ̇).
  struct Contact {
    Index gap;
    Index work;        ///< ∫ f δ̇ dt, or −1
    Index impulse;     ///< ∫ f dt, or −1
    Index guard;       ///< of the gap
    Index load_guard;  ///< of k δ + c δ̇, or −1
    double stiffness, damping, exponent;
    double length;   ///< natural indentation
    double shallow;  ///< indentation that cannot be told from rounding
    double level = 0;
    Role role = Role::open;

    bool pushes() const { return role == Role::closed || role == Role::touching; }
    /// Indentation from which a contact touched at rest is watched: out of the noise.
    double loaded() const { return 2 * shallow; }
  };
  std::vector<Body> body;
  std::vector<Contact> contact;
  double speed = 1;      ///< natural relative speed
  double faint = 0;      ///< rate at which a contact that has become shallow fades
  bool goes_on = false;  ///< the bodies are some of a longer row, which a touching contact may press
};

/// True if what a touching contact presses may lie beyond the phase.
inline bool presses_beyond(const SerialPhase& phase) {
  const auto touches = [](const SerialPhase::Contact& c) { return c.role == SerialPhase::Role::touching; };
  return phase.goes_on && std::any_of(phase.contact.begin(), phase.contact.end(), touches);
}

/// True if a constant acceleration acts on any body.
inline bool has_acceleration(const SerialPhase& phase) {
  for (const auto& body : phase.body)
    if (body.acceleration != 0) return true;
  return false;
}

}  // namespace mariotte::flow
