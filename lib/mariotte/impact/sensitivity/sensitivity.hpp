// Exact slopes of the outcome of an impact by its parameters, through every event.
#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/sensitivity/parameter.hpp"
#include "mariotte/impact/sensitivity/slope_note.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::impact {

/// Called at every step of a run with slopes; what it throws reaches the caller.
using SlopeWatch = std::function<void()>;

/// One outcome and its slopes by every parameter [unit of the outcome / unit of the parameter].
struct OutcomeSlopes {
  std::string name;            ///< "velocity", "impulse", "icr", "time", …
  std::optional<Index> index;  ///< of an array, from 0
  std::string unit;            ///< of the outcome
  std::optional<double> value = {};
  std::vector<std::optional<double>> slope = {};  ///< empty where there is none
};

/// True of a slope with which an outcome changes by rounding alone where its parameter changes by `change`.
inline bool is_rounding(double slope, double change, double outcome) {
  constexpr double least = 1e-12;
  return std::abs(slope * change) <= least * std::abs(outcome);
}

/// "velocity[0]", or "time".
inline std::string name_of(const OutcomeSlopes& outcome) {
  return outcome.index ? outcome.name + "[" + std::to_string(*outcome.index) + "]" : outcome.name;
}

/// What a parameter is.
struct ParameterValue {
  std::string name;
  double value;
};

/// The outcome of a run and how it moves.
struct Sensitivity {
  hybrid::Ending ending = hybrid::Ending::failed;
  std::string message;  ///< why, for endings other than separated
  std::vector<ParameterValue> parameter;
  std::vector<OutcomeSlopes> outcome;
  std::vector<SlopeNote> notes;  ///< where slopes are large, one-sided or missing, and why
  bool is_swept_back = false;    ///< from its one outcome, through the run
  bool in_doubt = false;         ///< a note says that slopes may be wrong
};

/// The numbers of a chain: masses, velocities, gaps, numbers of its laws, and gravity if it acts.
std::vector<Parameter<model::Chain>> parameters(const model::Chain& chain);
/// Of a network: its diagonal masses, velocities, gaps and numbers of its laws.
std::vector<Parameter<model::Network>> parameters(const model::Network& network);
/// Of bodies: mass, moments, radii, place, velocity and spin of each, numbers of the contacts that are named,
/// or of all if they are few, and gravity as far as it acts.
std::vector<Parameter<model::Bodies>> parameters(const model::Bodies& bodies);

/// Slopes of final velocities, impulses, their ratios and the time of the ending. Throws InvalidParameter as
/// `simulate`.
Sensitivity sensitivity(
    const model::Chain& chain, const std::vector<Parameter<model::Chain>>& by,
    const hybrid::Options& options = {}, const SlopeWatch& watch = [] {});
/// The same; ratios are those of contacts in their order.
Sensitivity sensitivity(
    const model::Network& network, const std::vector<Parameter<model::Network>>& by,
    const hybrid::Options& options = {}, const SlopeWatch& watch = [] {});
/// Slopes of the velocity of the mass centre along the normal, of v3 and of the spin about e2, of the contact
/// time and of the restitution of the tip.
Sensitivity sensitivity(
    const model::Microbody& body, const std::vector<Parameter<model::Microbody>>& by,
    const hybrid::Options& options = {}, const SlopeWatch& watch = [] {});
/// Slopes of final velocities and spins, of what contacts exchange and lose, and of the time of the ending.
/// Of power laws alone.
Sensitivity sensitivity(
    const model::Bodies& bodies, const std::vector<Parameter<model::Bodies>>& by,
    const hybrid::Options& options = {}, const SlopeWatch& watch = [] {});

}  // namespace mariotte::impact
