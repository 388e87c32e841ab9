// The contacts that the Taylor flow expands: the ones that carry force, and those whose bodies they move.
// Everything outside flies freely.
#pragma once
#include <span>
#include <vector>

#include "mariotte/flow/problem.hpp"
#include "mariotte/flow/taylor/taylor_lanes.hpp"

namespace mariotte::flow::taylor {

/// A drive during a step, as series in time.
struct DriveSeries {
  struct Share {
    int of;
    double coefficient;
  };
  std::vector<Share> on_lane, on_velocity;  ///< of its change
  Coefficients gain;                        ///< ∫ of that
  Coefficients work;                        ///< that it does
  double done = 0;                          ///< before the step, since the window was placed
};

/// A contact outside whose gap changes, from what it is at `since`.
struct Loose {
  Index gap;
  double rate;          ///< δ̇ at `since`
  double acceleration;  ///< δ̈
};

/// The contacts that are expanded, one lane each, and the motion of all others.
struct Window {
  const SerialPhase* row = nullptr;  ///< one of the two is what the window shows
  const LinkedPhase* network = nullptr;
  std::vector<const PhaseContact*> contacts;  ///< one per lane
  double speed = 1, fade_speed = 0;           ///< those of the phase
  State x;           ///< the whole state at `since`; what is outside is as it was then
  double since = 0;  ///< local time of the phase
  double time = 0;
  Index first = 0;  ///< contact of lane 0
  Lanes lanes;
  Coupling coupling;                  ///< of a part of a network
  std::vector<char> at_edge;          ///< of a network: lanes that push on bodies outside
  std::vector<int> lane_of, found;    ///< of a network: of each contact, or −1; those inside
  std::vector<double> velocity;       ///< of bodies first, first + 1, … of a row, of all dofs of a network
  bool is_pulled = false;             ///< some contact has a constant pull
  std::vector<double> impulse, work;  ///< since `since`
  std::vector<double> stored;         ///< at `since`
  std::vector<const WidthBranch*> branch;    ///< of each lane
  std::vector<const CubicSegment*> segment;  ///< of each lane
  double outside_time = infinity;  ///< when the first of the gaps outside closes, or a drive has a kink
  Index outside_guard = -1;        ///< that of either
  const PhaseContact* outside = nullptr;  ///< that contact, or null
  std::vector<Loose> loose;
  bool falls_outside = false;      ///< bodies may fall there
  const Drives* drives = nullptr;  ///< all is inside then
  std::vector<DriveSeries> driven;
  std::vector<double> bend;  ///< Lanes::bend

  const PhaseContact& contact(int lane) const { return *contacts[lane]; }
  /// Of a network: the number of lane's contact in the phase.
  Index number(int lane) const { return contacts[lane] - network->contact.data(); }
  /// Of lane's contact the force is a function with a branch point at δ = 0.
  bool is_sharp(int lane) const { return lanes.power[lane] > 0; }
  bool has_root(int lane) const { return lanes.rooted[lane] > 0; }
  bool pushes(int lane) const { return contact(lane).pushes(); }
  /// Others than its neighbours in a row may draw a contact apart.
  bool is_linked() const { return network || drives; }
  /// Something may draw contacts apart whose force is left out, so that one is deepest within a step.
  bool may_draw() const { return is_linked() || falls_outside || is_pulled; }
};

/// Place the window around what moves or pushes at `time`, where the whole state is x.
void place(Window& window, const Problem& problem, State x, double time);

/// A contact at the edge is about to push on a body outside.
bool has_outgrown(const Window& window);

/// Contacts of a row that have opened at its left leave so few that a smaller number of lanes holds them.
bool has_shrunk(const Window& window);

/// A closed contact opens where its indentation falls to −level.
inline double end_level(const PhaseContact& contact) {
  return contact.origin - contact.level;
}

/// Watch lane's guards as its contact's role demands.
void watch(Window& window, int lane);

/// Move on to what an expansion says.
void advance(Window& window, const Values& values);
/// What rounding of the velocities, or an error of the rate, makes of the load of a lane.
double load_noise(const Window& window, int lane, double rate_error);
/// The load of a lane is no more than rounding.
bool has_faint_load(const Window& window, int lane);

/// Write the whole state at the window's time to x, which may be the window's own.
void write(const Window& window, State x);

/// Write the state that an expansion from there says to another x.
void write(const Window& window, const Values& values, State x);

}  // namespace mariotte::flow::taylor
