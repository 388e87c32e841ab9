// Chains of three balls, of which many are followed side by side.
#pragma once
#include <optional>

#include "mariotte/core/natural_root.hpp"
#include "mariotte/flow/triplet/triplet.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// The numbers of a chain with two undamped Hertz contacts and no wall, on which nothing else acts.
struct TripletScene {
  double mass[3], velocity[3], stiffness[2], gap[2];
  double speed;           ///< reference speed
  double unit_stiffness;  ///< that is 1 in the units of `scale`
  Scale scale;
};

/// Those of a validated chain; empty unless it is such a one, numbers are of moderate size, and nothing is
/// asked for but an accuracy.
std::optional<TripletScene> triplet_scene(const model::Chain& chain, const hybrid::Options& options,
                                          NaturalRoot& natural_root);

/// A chain of three balls, for `restore`.
model::Chain any_triplet();
/// The numbers of a triplet, put back.
void restore(const TripletScene& scene, model::Chain& chain);

/// The triplet at its start, dimensionless.
flow::Triplet dimensionless(const TripletScene& scene, double accuracy);

/// What came out of a triplet that is over, in units. False if a balance does not close.
bool describe(const TripletScene& scene, const flow::Triplet& triplet, double accuracy, BriefImpact& impact);

}  // namespace mariotte::impact
