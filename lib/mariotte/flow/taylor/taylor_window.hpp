// The part of a chain that the Taylor flow expands: the contacts that carry force and one more on each side.
// Everything outside flies freely.
#pragma once
#include "mariotte/flow/problem.hpp"
#include "mariotte/flow/taylor/taylor_lanes.hpp"

namespace mariotte::flow::taylor {

/// The contacts that are expanded, one lane each, and the motion of all others.
struct Window {
  const SerialPhase* phase = nullptr;
  State x;           ///< the whole state at `since`; what is outside is as it was then
  double since = 0;  ///< local time of the phase
  double time = 0;
  Index first = 0;  ///< contact of lane 0
  Lanes lanes;
  double velocity[lane_limit + 1];               ///< of bodies first, first + 1, …
  double wake[lane_limit];                       ///< indentation below which a contact's force is left out
  double impulse[lane_limit], work[lane_limit];  ///< since `since`
  double outside_time = 0;                       ///< when the first of the gaps outside closes
  Index outside = -1;                            ///< that contact

  const PhaseContact& contact(int lane) const { return phase->contact[first + lane]; }
  /// Of lane's contact the force is a function with a branch point at δ = 0.
  bool is_sharp(int lane) const { return lanes.power[lane] > 0; }
  bool pushes(int lane) const {
    const auto role = contact(lane).role;
    return role == Role::closed || role == Role::touching;
  }
};

/// Place the window around what moves or pushes at `time`, where the whole state is x. False if that needs
/// more lanes than there are.
bool place(Window& window, const SerialPhase& phase, State x, double time);

/// Watch lane's guards as its contact's role demands.
void watch(Window& window, int lane);

/// Move on to what an expansion says.
void advance(Window& window, const Values& values);

/// Write the whole state at the window's time to x, which may be the window's own.
void write(const Window& window, State x);

/// Write the state that an expansion from there says to another x.
void write(const Window& window, const Values& values, State x);

}  // namespace mariotte::flow::taylor
