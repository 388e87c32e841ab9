// Bodies in a row, seen as what they are: what the flows that need more than a field are made for.
#pragma once
#include <algorithm>
#include <vector>

#include "mariotte/flow/phase_contact.hpp"

namespace mariotte::flow {

/// A phase of bodies on a line, each with a contact to the next, under constant outside accelerations: where
/// its quantities stand in the state.
struct SerialPhase {
  /// One of the bodies in the row.
  struct Body {
    Index velocity;
    double inverse_mass;
    double acceleration;
  };
  /// Contact j joins bodies j and j+1.
  std::vector<Body> body;
  std::vector<PhaseContact> contact;
  double speed = 1;          ///< natural relative speed
  double reached_speed = 1;  ///< of it what dampers do not hold back: what rounding of rates is relative to
  double fade_speed = 0;     ///< rate at which a contact fades that is less deep than its faded()
  bool is_slice = false;     ///< the bodies are some of a longer row, which a touching contact may press
};

/// True if what a touching contact presses may lie beyond the phase.
inline bool presses_beyond(const SerialPhase& phase) {
  const auto touches = [](const PhaseContact& c) { return c.role == Role::touching; };
  return phase.is_slice && std::any_of(phase.contact.begin(), phase.contact.end(), touches);
}

/// True if a constant acceleration acts on any body.
inline bool has_acceleration(const SerialPhase& phase) {
  for (const auto& body : phase.body)
    if (body.acceleration != 0) return true;
  return false;
}

}  // namespace mariotte::flow
