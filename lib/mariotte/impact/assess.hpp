// The validity of a run, from its result and what is known of its bodies.
#pragma once
#include <span>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"

namespace mariotte::impact {

/// Fills in `impact.validity`; an indentation of more than a radius makes the ending `invalid`, and the
/// message names the contact. `touching` has an entry per contact of the model, or per tip; or
/// none at all.
void assess(ContactImpact& impact, std::span<const contact::Law> laws, std::span<const Touching> touching);
void assess(BodiesImpact& impact, const model::Bodies& bodies, std::span<const Touching> touching);
void assess(MicrobodyImpact& impact, const model::Microbody& body, std::span<const Touching> touching);

/// Whether a run of contacts with these laws may have a number of the validity.
bool has_validity(std::span<const contact::Law> laws, std::span<const Touching> touching);

}  // namespace mariotte::impact
