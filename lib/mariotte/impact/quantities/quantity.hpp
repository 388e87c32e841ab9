// What results say, as lists: of every quantity its key, unit and meaning, and how to read it. JSON, tables,
// columns of sweeps, attributes of HDF5, labels of figures and the page of the result format come from here.
#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/impact/network/network_solver.hpp"
#include "mariotte/impact/quantities/description.hpp"

namespace mariotte::impact {

/// Indices of the arrays on the way to a quantity, from 0, the outermost first.
using Indices = std::array<Index, 3>;

/// This result has no such key.
struct Omitted {};

/// What a result says: monostate where a number is undefined, which JSON writes as null.
using Value = std::variant<std::monostate, Omitted, double, Index, bool, std::string_view>;

/// Length of an array; empty if this result has none, which JSON writes as null.
using Count = std::optional<Index>;

/// What the quickest Solver of a model gives, beside the model; `serves` says which models it can solve.
template <class Impact>
struct Brief;

template <>
struct Brief<ChainImpact> {
  /// Values agree with those of runs that carry slopes or histories.
  struct Solver : ChainSolver {
    Solver() : ChainSolver(Course::of_simulate) {}
  };
  static bool serves(const model::Chain&) { return true; }

  const model::Chain& chain;
  const BriefImpact& impact;
};

template <>
struct Brief<NetworkImpact> {
  using Solver = NetworkSolver;
  static bool serves(const model::Network&) { return true; }

  const model::Network& network;
  const BriefImpact& impact;
};

/// Of a body that has one impact.
template <>
struct Brief<MicrobodyImpact> {
  struct Solver : MicrobodySolver {  // as of chains
    Solver() : MicrobodySolver(Course::of_simulate) {}
  };
  static bool serves(const model::Microbody& body) { return body.impacts == 1; }

  const model::Microbody& body;
  const BriefMicrobodyImpact& impact;
};

/// Bodies have no solver that is quicker than `simulate`.
struct BodiesSolver {
  BodiesImpact impact;
  const BodiesImpact& solve(const model::Bodies& bodies, const hybrid::Options& options) {
    return impact = simulate(bodies, options);
  }
};

template <>
struct Brief<BodiesImpact> {
  using Solver = BodiesSolver;
  static bool serves(const model::Bodies&) { return false; }

  const model::Bodies& bodies;
  const BodiesImpact& impact;
};

/// One entry of the list of an impact. `read` and `count` need indices that exist in the result; `brief` says
/// that nothing is there.
template <class Impact>
struct Quantity {
  Description is;
  Value (*read)(const Impact&, Indices) = nullptr;         ///< none for an array of objects or arrays
  Count (*count)(const Impact&, Indices) = nullptr;        ///< of an array: of its last index
  bool counted_by_run = false;                             ///< the model does not say how long the array is
  bool needs_peaks = false;                                ///< every step has to be searched for it
  Value (*brief)(const Brief<Impact>&, Indices) = nullptr; /**< the same from the quickest solver, or the
                                                                count where there is no `read` */
};

/// All quantities of a result, in the order of its JSON. An array of objects comes before their members.
template <class Impact>
const std::vector<Quantity<Impact>>& quantities();

template <>
const std::vector<Quantity<ChainImpact>>& quantities();
template <>
const std::vector<Quantity<NetworkImpact>>& quantities();
template <>
const std::vector<Quantity<MicrobodyImpact>>& quantities();
template <>
const std::vector<Quantity<BodiesImpact>>& quantities();

/// What it takes to know a quantity, from cheap to dear.
enum class Cost { brief, whole, peaks };

template <class Impact>
Cost cost(const Quantity<Impact>& quantity) {
  return quantity.brief ? Cost::brief : quantity.needs_peaks ? Cost::peaks : Cost::whole;
}

/// A result whose arrays have the lengths that the model alone decides; all else is empty.
ChainImpact unfilled(const model::Chain& chain);
NetworkImpact unfilled(const model::Network& network);
MicrobodyImpact unfilled(const model::Microbody& body);
BodiesImpact unfilled(const model::Bodies& bodies);

}  // namespace mariotte::impact
