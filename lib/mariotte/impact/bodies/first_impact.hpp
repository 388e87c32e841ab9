// The first impact of bodies in the plane: what the compliant contact does, beside what impact laws with
// friction answer for rigid bodies.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/laws/frictional_contact.hpp"

namespace mariotte::impact {

/// Linear and angular velocity of a body in the plane.
struct PlaneMotion {
  Vector3 velocity;  ///< of the mass centre [m/s]
  double spin = 0;   ///< [rad/s]
};

/// What a law answers, or what the simulation did.
struct FrictionOutcome {
  std::string law;                         ///< "simulation", "newton", "poisson", "moreau", "stronge"
  std::optional<double> restitution = {};  ///< of the law's own kind; none of a simulation
  InContact impulse = {};                  ///< on b [N s]
  InContact velocity = {};                 ///< of b on a afterwards [m/s]
  double energy = 0;                       ///< kinetic, of all bodies afterwards [J]
  double loss = 0;                         ///< in the contact; negative if the law gains energy there [J]
  std::vector<PlaneMotion> body = {};      ///< afterwards
};

/// From where the contact closes to where it opens.
struct FirstImpact {
  std::array<std::string, 2> between;  ///< names of a and b
  double start = 0, end = 0;           ///< [s]
  FrictionalContact contact;           ///< W, velocity and friction at the start
  double energy = 0;                   ///< kinetic, of all bodies at the start [J]
  std::vector<FrictionOutcome> outcomes;
};

/// Simulates until the first contact has opened, and applies every law to the velocities with which it
/// closed. Each has the restitution that the simulation had in the law's own sense (of velocities for Newton
/// and Moreau, of normal impulses for Poisson, of the work of the normal force for Stronge), or all the given
/// one. Throws InvalidParameter unless the bodies are in the plane and another contact stays open meanwhile.
FirstImpact first_impact(const model::Bodies& bodies, const hybrid::Options& options,
                         std::optional<double> restitution = {});

}  // namespace mariotte::impact
