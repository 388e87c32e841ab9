// The first impact of bodies in the plane as a simulation has it, and what laws would have to be told of it.
#pragma once
#include "mariotte/impact/bodies/first_impact.hpp"

namespace mariotte::impact {

/// When a contact, counted in the list of the bodies, is closed first.
struct Closure {
  Index contact;
  double start, end;
};

/// Throws InvalidParameter unless some contact closes and opens again, alone.
Closure first_closure(const BodiesImpact& run);
/// What a run says of a contact.
const BodyContactHistory& history_of(const BodiesImpact& run, Index contact);
/// The bodies as a simulation has them at a time; throws Error where it fails.
model::Bodies bodies_after(const model::Bodies& bodies, const hybrid::Options& options, double time);

/// A simulated impact with what laws would have to be told of it.
struct Compliant {
  FrictionOutcome outcome;
  double kinematic, kinetic, energetic;  ///< coefficients of restitution
};

/// That of a contact that closes at a rate of the gap `approach` < 0.
Compliant compliant_impact(const model::Bodies& bodies, const hybrid::Options& options,
                           const Closure& closure, double approach);

}  // namespace mariotte::impact
