// What `mariotte law` is asked, from flags and a scene.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/impact/laws/icr_table.hpp"
#include "mariotte/report/table/friction_law_report.hpp"
#include "mariotte/report/table/law_report.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {

/// Texts of the flags; empty for those not given.
struct LawChoice {
  SceneChoice scene;
  std::vector<std::string> mass, velocity, icr, direction;
  std::string energy_ratio, frame, restitution;
  std::string table;            ///< file of ratios
  std::vector<std::string> at;  ///< NAME=VALUE, one per axis of the table that has more than one value
  bool rivals = false;
  bool json = false;
};

struct LawProblem {
  std::optional<impact::TableAnswer> from_table;
  report::LawReport report;        ///< all but its outcomes
  impact::RivalParameters rivals;  ///< with stiffnesses and exponents of the contacts of a scene
  hybrid::Ending simulation_ended = hybrid::Ending::separated;
  std::string message;                ///< why, for endings other than separated
  std::vector<std::string> warnings;  ///< of the simulation
};

/// The scene of the choice, or one without a model.
scene::Scene scene_of(const LawChoice& choice);

/// A table or flags go before the scene's [law], that before a simulation of its [chain]. Throws UsageError
/// where flags make no sense or something is missing, impact::OutsideTable, and what simulating a scene
/// throws.
LawProblem law_problem(const LawChoice& choice, const scene::Scene& scene);

/// Laws with friction beside the first impact of the scene's bodies. Throws UsageError for flags that are not
/// for bodies, and what simulating them throws.
report::FrictionLawReport friction_laws(const LawChoice& choice, const scene::Scene& scene,
                                        const model::Bodies& bodies);

}  // namespace mariotte::command
