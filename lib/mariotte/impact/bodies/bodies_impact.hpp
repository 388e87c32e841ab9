// What bodies with friction do from start to separation: the quantities a researcher asks for, in the units
// of the bodies.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/model/bodies/body_event.hpp"

namespace mariotte::impact {

/// One body at the end. In the plane the attitude is a turn about e3.
struct BodyEnd {
  Vector3 position;  ///< of the mass centre [m]
  Quaternion attitude;
  double angle = 0;  ///< in the plane, in (−π, π] [rad]
  Vector3 velocity;  ///< of the mass centre [m/s]
  Vector3 spin;      ///< space axes [rad/s]
};

/// Energy lost in contacts, each ≥ 0 [J].
struct ContactLosses {
  double friction = 0;  ///< by slip
  double rescale = 0;   ///< by Mindlin's law, whose stiffness falls on unloading
  double damper = 0;    ///< by dampers of the normal laws
  double plastic = 0;   ///< by yielding
  double adhesion = 0;  ///< where adhesive contacts snap in and let go

  double total() const { return friction + rescale + damper + plastic + adhesion; }
};
inline constexpr std::array each_loss = {&ContactLosses::friction, &ContactLosses::rescale,
                                         &ContactLosses::damper, &ContactLosses::plastic,
                                         &ContactLosses::adhesion};

/// What one contact did.
struct BodyContactHistory {
  std::array<std::string, 2> between;  ///< names of a and b
  Index contact = 0;                   ///< in the list of the bodies, from 0
  double normal_impulse = 0;           ///< ∫ f_n dt [N s]
  Vector3 tangential_impulse;          ///< of b; in the plane e1 is along e_z × n [N s]
  ContactLosses losses;
  double stored = 0;              ///< elastic energy left at the end [J]
  double stored_in_friction = 0;  ///< of it, that of the spring along the plane [J]
  double peak_force = 0;          ///< largest f_n [N]
  double peak_friction = 0;       ///< largest |f_t| [N]
  double peak_indentation = 0;    ///< [m]
  std::vector<Period> periods;    ///< in order of time
  MeetingSpeeds meeting;
};

/// What contacts do at one instant; they count from 0 in the list of results.
struct BodiesEvents {
  double time;                                                  ///< [s]
  std::array<std::vector<Index>, model::body_events> all = {};  ///< by model::BodyEvent

  const std::vector<Index>& of(model::BodyEvent event) const { return all[static_cast<std::size_t>(event)]; }
};

/// final + stored + losses − initial − work = residual [J].
struct BodiesBalance {
  double initial = 0, final = 0;  ///< kinetic
  double stored = 0;              ///< in contacts that are closed at the end
  ContactLosses losses;
  double work = 0;  ///< of gravity and moving planes
  double residual = 0;
};

/// Samples of a run, one row per time; filled only on request.
struct BodiesTrace {
  std::vector<double> time;                    ///< [s]
  std::vector<std::vector<BodyEnd>> body;      ///< a value per body
  std::vector<std::vector<double>> gap;        ///< a value per contact [m]
  std::vector<std::vector<double>> force;      ///< f_n per contact [N]
  std::vector<std::vector<Vector3>> friction;  ///< on b per contact [N]
  std::vector<std::vector<Vector3>> slip;      ///< of b on a per contact [m/s]
};

/// All that a run of bodies leaves, in SI.
struct BodiesImpact {
  hybrid::Ending ending = hybrid::Ending::separated;
  std::string message;  ///< why, for endings other than separated; else empty
  int dimension = 3;
  double time = 0;  ///< of the ending [s]
  std::vector<BodyEnd> body;
  std::vector<BodyContactHistory> contacts;  ///< as many as are always told, then all that have closed
  std::vector<BodiesEvents> events;          ///< in order of time
  BodiesBalance energy;
  Vector3 momentum_residual;          ///< final − initial − impulses of planes and gravity [N s]
  Vector3 angular_momentum_residual;  ///< the same about the origin; zero unless there are planes [N m s]
  Validity validity;
  std::vector<FlowUse> flows;
  std::vector<Skipped> skipped;
  double requested_accuracy = 0;
  std::optional<double> estimated_accuracy;
  double slowing = 1;      ///< how many times slower than it met a contact that adheres let go, at most
  double lost_digits = 0;  ///< share of indentations that has been lost to rounding on the way to contacts
  BodiesTrace trace;
};

/// Of its trace the velocities, body by body with all components, gaps and normal forces of its contacts, or
/// of those that have closed.
Trace contact_trace(const BodiesImpact& impact, bool closed_alone = false);

/// Simulate bodies until they separate for good, or a limit. Throws InvalidParameter for bodies, accuracy or
/// flow that make no sense, and Error where contacts that stick rigidly are redundant.
BodiesImpact simulate(const model::Bodies& bodies, const hybrid::Options& options = {},
                      const RunObserver& observers = {});

/// Error of the final velocities, and of spin × reach, relative to the largest incident speed, from a second
/// run at a tighter accuracy and, of up to 50 bodies, one by a flow that shares no formula.
double estimate_accuracy(const model::Bodies& bodies, const hybrid::Options& options,
                         const BodiesImpact& result);

}  // namespace mariotte::impact
