// The impact of a chain, from start to separation: the quantities a researcher asks for, in the chain's
// units.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/flow_use.hpp"
#include "mariotte/impact/validity.hpp"
#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// A interval of time in which one contact carries force [s]; `end` is empty if it still does at the end.
struct Period {
  double start;
  std::optional<double> end;
};

/// How fast two bodies came together and parted, at the ends of the first period of their contact [m/s].
struct MeetingSpeeds {
  std::optional<double> approach;    ///< empty if they never met, or were indented from the start
  std::optional<double> separation;  ///< empty if they did not part
};

/// What one contact did.
struct ContactHistory {
  double impulse = 0;                ///< p = ∫ f dt [N s]
  double peak_force = 0;             ///< [N]
  double peak_indentation = 0;       ///< [m]
  double stored = 0;                 ///< elastic energy left at the end [J]
  double dissipated = 0;             ///< energy lost, ≥ 0 [J]
  double plastic = 0;                ///< of it, by yielding [J]
  double adhesion = 0;               ///< of it, where adhesion snapped in and gave way [J]
  double permanent_indentation = 0;  ///< depth of the dent, where the contact closes again [m]
  std::vector<Period> periods;       ///< in order of time
  MeetingSpeeds meeting;
};

/// One instant at which the set of force-carrying contacts changes, or the branch of one; contacts count
/// from 0.
struct Event {
  double time;  ///< [s]
  std::vector<Index> open = {};
  std::vector<Index> close = {};
  std::vector<Index> yield = {};   ///< become plastic, for the first time or again
  std::vector<Index> unload = {};  ///< turn back from there
};

/// True if a contact has yielded.
inline bool has_branches(const std::vector<Event>& events) {
  for (const auto& event : events)
    if (!event.yield.empty() || !event.unload.empty()) return true;
  return false;
}

/// final + stored + dissipated − initial − work = residual [J].
struct EnergyBalance {
  double initial = 0;               ///< kinetic plus stored energy at the start
  double final = 0;                 ///< kinetic energy at the end
  double stored = 0;                ///< elastic energy at the end
  double dissipated = 0;            ///< Σ over contacts
  double plastic = 0;               ///< of it, by yielding
  double adhesion = 0;              ///< of it, where adhesion snapped in and gave way
  double work = 0;                  ///< done on the balls by gravity, moving walls and drives
  double residual = 0;              ///< error of the balance
  std::optional<double> ratio_lab;  ///< kinetic energy ratio T⁺/T⁻ in the given frame; empty if T⁻ = 0
  std::optional<double> ratio_centre;  ///< the same relative to the mass centre; empty with walls, too
};

/// Momentum of the balls of finite mass [N s].
struct MomentumBalance {
  double initial = 0;
  double final = 0;
  double residual = 0;  ///< final − initial − impulses of walls, gravity and given forces
};

/// Samples of a run, one row per time; filled only on request.
struct Trace {
  std::vector<double> time;                   ///< [s]
  std::vector<std::vector<double>> velocity;  ///< rows of n values
  std::vector<std::vector<double>> gap;       ///< rows of m values [m]
  std::vector<std::vector<double>> force;     ///< rows of m values [N]
  std::string moving = "ball";                ///< what has a velocity
  std::string velocity_unit = "m/s";          ///< empty where units differ
  Index dimension = 1;                        ///< velocities that each of these has
};

/// What every model made of contacts has to tell: n velocities, m contacts.
struct ContactImpact {
  hybrid::Ending ending = hybrid::Ending::separated;
  std::string message;  ///< why, for endings other than separated; else empty
  double time = 0;      ///< of the ending [s]
  /// After the impact, n values: of the balls of a chain from left to right, positive to the right [m/s]; of
  /// the degrees of freedom of a network, in its order and units.
  std::vector<double> velocity;
  std::vector<double> gap;  ///< m values [m]
  std::vector<ContactHistory> contacts;
  std::vector<std::optional<double>> icr;  ///< α_j = p_j/p_{j+1}, m−1 values; empty where p_{j+1} = 0
  std::vector<double> impulse_direction;   ///< r = p/|p|, m values; zeros if no impulse was exchanged
  std::vector<Event> events;               ///< in order of time
  EnergyBalance energy;
  Validity validity;  ///< empty unless something is known of the bodies: `scene::simulate` fills it in
  std::vector<FlowUse> flows;
  std::vector<Skipped> skipped;
  double slowing = 1;  ///< how many times slower than it met a contact that adheres let go, at most
  /// Contacts that let go within the noise of their gap: when, the accuracy decides.
  std::vector<Index> faded;
  double requested_accuracy = 0;
  std::optional<double> estimated_accuracy;  ///< where errors may have grown, or from estimate_accuracy
  /// Of small oscillations of the contacts that adhesion holds together for ever, ascending [Hz]; empty but
  /// at the ending `bound`.
  std::vector<double> bound_frequency;
  Trace trace;
};

/// Of n balls and m = n−1 contacts.
struct ChainImpact : ContactImpact {
  MomentumBalance momentum;
};

/// Simulate a chain until it separates for good, or a limit. Throws InvalidParameter for a chain, accuracy or
/// flow that makes no sense, and for samplings of balls or contacts that do not exist.
ChainImpact simulate(const model::Chain& chain, const hybrid::Options& options = {},
                     const RunObserver& observers = {});

/// A driven chain that knows which speeds are reached until the end of a run.
model::Chain with_reached_speeds(const model::Chain& chain, const hybrid::Options& options);

/// Error of `result.velocity` relative to the largest incident speed: the difference to a run at a tighter
/// accuracy and what that one may err by itself. Unless the chain is divided into islands also the difference
/// to a flow that shares no formula with it, CVODE, where that is more than CVODE's own error: that begins at
/// about 1e-12 and grows with what magnifies it.
double estimate_accuracy(const model::Chain& chain, const hybrid::Options& options,
                         const ChainImpact& result);

}  // namespace mariotte::impact
