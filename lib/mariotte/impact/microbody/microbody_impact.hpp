// The impact of a microbody on a plane: the quantities a researcher asks for, in the body's units.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/laws/restitution.hpp"
#include "mariotte/model/microbody/microbody.hpp"

namespace mariotte::impact {

/// State of the body at one instant.
struct BodyState {
  double time = 0;   ///< [s]
  Vector3 position;  ///< of the mass centre: height over the plane, then from where it started [m]
  Quaternion attitude;
  Vector3 velocity;  ///< of the mass centre: away from the plane, then along it [m/s]
  Vector3 spin;      ///< space axes [rad/s]
};

/// One contact of one tip, from touch to separation; `end` is empty if it does not separate.
struct TipImpact {
  Index tip = 0;
  double start = 0;
  std::optional<double> end = {};
  double normal_velocity_in = 0, normal_velocity_out = 0;  ///< of the tip
  double centre_velocity_in = 0, centre_velocity_out = 0;  ///< of the mass centre, along the normal
  Vector3 slip_out = {};                                   ///< tangential velocity of the contact point
  double peak_force = 0;                                   ///< largest push [N]
  double peak_pull = 0;                                    ///< largest pull, ≥ 0 [N]
  double peak_indentation = 0;                             ///< [m]
};

/// What happens to the tips at one instant; tips count from 0.
struct TipEvents {
  double time;  ///< [s]
  std::vector<Index> open = {}, close = {}, stick = {}, slip = {}, capture = {};
  std::vector<Index> push = {}, pull = {};  ///< F_n turns positive, negative
};

/// final + stored + Σ losses − initial − work = residual [J].
struct MicrobodyBalance {
  double initial = 0, final = 0;  ///< kinetic
  double stored = 0;              ///< of contacts that are still closed; negative in the well
  double hertz_damping = 0, adhesion_damping = 0, friction = 0;  ///< losses, ≥ 0
  double work = 0;                                               ///< of gravity
  double residual = 0;

  double dissipated() const { return hertz_damping + adhesion_damping + friction; }
};

/// Where a captured tip comes to rest: as deep as the ring of adhesion balances the Hertz force.
struct RestState {
  Index tip;
  double indentation;  ///< [m]
};

/// Samples of a run, one row per time; filled only on request.
struct BodyTrace {
  std::vector<BodyState> state;
  std::vector<std::vector<double>> gap, normal_force;  ///< a value per tip [m], [N]
  std::vector<std::vector<Vector3>> friction, slip;    ///< a value per tip [N], [m/s]
};

/// All that a run of a body leaves, in SI.
struct MicrobodyImpact {
  hybrid::Ending ending = hybrid::Ending::separated;
  std::string message;  ///< why, for endings other than separated and captured; else empty
  BodyState final;
  Restitution restitution;  ///< of the first impact
  std::vector<TipImpact> impacts;
  std::vector<TipEvents> events;
  std::optional<RestState> rest;  ///< if captured
  bool shared_friction = false;  ///< two tips stuck at once, and least norm divided the friction between them
  MicrobodyBalance energy;
  Vector3 impulse;    ///< of the plane on the body [N s]
  Validity validity;  ///< filled in by `scene::simulate`
  std::vector<FlowUse> flows;
  std::vector<Skipped> skipped;
  double slowing = 1;  ///< how many times slower than it met a tip that adheres let go, at most
  double requested_accuracy = 0;
  std::optional<double> estimated_accuracy;  ///< where a run took many steps, or from estimate_accuracy
  BodyTrace trace;
};

/// Whether the first contact has come to an end, by rebound or capture: without it there is no restitution.
bool has_restitution(const MicrobodyImpact& impact);

/// Simulate a microbody until it is captured, has had its impacts or flies off for good, or a limit. Throws
/// InvalidParameter for a body, accuracy or flow that makes no sense, and for samplings of what does not
/// exist.
MicrobodyImpact simulate(const model::Microbody& body, const hybrid::Options& options = {},
                         const RunObserver& observers = {});

/// Error of the final velocity, and of spin × reach, relative to the largest incident speed, from a second
/// run at a tighter accuracy and one by a flow that shares no formula.
double estimate_accuracy(const model::Microbody& body, const hybrid::Options& options,
                         const MicrobodyImpact& result);

}  // namespace mariotte::impact
