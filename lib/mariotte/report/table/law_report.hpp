// What `mariotte law` says.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/impact/laws/multiple_impact_law.hpp"
#include "mariotte/impact/laws/rival_laws.hpp"
#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// The law applied to a chain or network, and where its parameters come from.
struct LawReport {
  std::string title;
  impact::Configuration before;
  impact::LawParameters parameters;
  impact::LawOutcome outcome;
  std::vector<double> simulated = {};  ///< velocities of the simulation the parameters are from, or empty
  std::optional<double> velocity_error = {};      ///< bound on the error of interpolated parameters
  std::vector<impact::NamedOutcome> rivals = {};  ///< on request
  double restitution = 1;                         ///< of the rivals
  std::string moving = "ball";                    ///< what has a velocity
  std::string velocity_unit = "m/s";              ///< empty where units differ
  std::string scene_sha256 = {};                  ///< empty if there is no scene
};

/// As the result of a run, with `status`, `reason`, `frame` and the least possible energy ratio.
Json json(const LawReport& report);
std::string table(const LawReport& report);

/// "given" or "mass-centre", as scenes and flags spell it.
const char* frame_name(impact::EnergyFrame frame);

}  // namespace mariotte::report
