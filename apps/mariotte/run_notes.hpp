// What a run says on stderr beside its result.
#pragma once
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::command {

void warn_of_error(double estimated, double requested, const char* why);

/// Why an estimate is larger than what was asked.
template <class Impact>
const char* why_inaccurate(const Impact&) {
  return "contacts close so often that errors grow";
}
const char* why_inaccurate(const impact::BodiesImpact& impact);

/// Where the promise of an accuracy could not be kept.
template <class Impact>
void warn_of_error(const Impact& impact) {
  if (impact.estimated_accuracy && *impact.estimated_accuracy > impact.requested_accuracy)
    warn_of_error(*impact.estimated_accuracy, impact.requested_accuracy, why_inaccurate(impact));
}

/// Balls that fly past each other are a slip more often than wanted.
void warn_of_nothing(const impact::ContactImpact& impact);
void warn_of_nothing(const impact::BodiesImpact& impact);
inline void warn_of_nothing(const impact::MicrobodyImpact&) {}

/// Where the model of a run does not hold.
void warn_of_limits(const impact::ContactImpact& impact);
void warn_of_limits(const impact::MicrobodyImpact& impact);
void warn_of_limits(const impact::BodiesImpact& impact);

/// Why a run ended early. A time limit and an interruption are the user's own wish, and only warned of.
void tell_ending(hybrid::Ending ending, const std::string& message, const scene::Scene& scene);

}  // namespace mariotte::command
