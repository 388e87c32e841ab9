// The result of a scene as text, in the formats of the command.
#pragma once
#include <string>

#include "mariotte/scene/simulate.hpp"

namespace mariotte::report {

/// One JSON object, as `mariotte run --json` prints it. SI units; `final.velocity` has one value per ball of
/// a chain, one per degree of freedom of a network, and of a microbody the three components of its mass
/// centre, the normal one first.
std::string json_text(const scene::Impact& impact, const scene::Scene& scene);

/// How much a table says.
enum class Detail {
  usual,
  full  ///< also how far the model holds, by which flows the run was followed, and what it did not need
};

/// What `mariotte run` prints, in full with -v: aligned text with units, at most 100 columns wide.
std::string table_text(const scene::Impact& impact, const scene::Scene& scene, Detail detail = Detail::usual);

/// `events.csv`: one row per event, with units in its head [s].
std::string events_text(const scene::Impact& impact);

/// `trace.csv`: one row per sample, with units in its head; empty of rows unless the run was traced.
std::string trace_text(const scene::Impact& impact);

}  // namespace mariotte::report
