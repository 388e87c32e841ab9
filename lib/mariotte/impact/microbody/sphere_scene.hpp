// Spheres that strike a plane along the normal, of which many are followed side by side.
#pragma once
#include <optional>

#include "mariotte/core/natural_root.hpp"
#include "mariotte/flow/sphere/sphere.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/model/microbody/microbody.hpp"

namespace mariotte::impact {

/// A sphere on which nothing acts but its contact.
struct SphereScene {
  double mass;
  Vector3 inertia;
  model::Tip tip;
  contact::BrachDunn law;
  contact::Coulomb friction;
  Quaternion attitude;
  model::Lever lever;
  model::AfterCapture after_capture;
  double speed;         ///< of the approach, in units of `velocity`
  double well;          ///< speed that the well of adhesion and the approach give, over that of the approach
  double velocity;      ///< unit of speeds
  double time;          ///< unit of times
  flow::Sphere sphere;  ///< at its start
};

/// That of a validated body; empty unless it is such a one, numbers are of moderate size, and nothing is
/// asked for but an accuracy that double precision has.
std::optional<SphereScene> sphere_scene(const model::Microbody& body, const hybrid::Options& options,
                                        NaturalRoot& natural_root);

/// The numbers of a sphere, put back into any body with one tip.
void restore(const SphereScene& scene, model::Microbody& body);

/// What came out of a sphere that was followed, in units. False where it is not told: the sphere did not
/// separate, its energy does not balance, or its steps were many.
bool describe(const SphereScene& scene, double accuracy, BriefMicrobodyImpact& impact);

}  // namespace mariotte::impact
