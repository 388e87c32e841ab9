// Many chains with the same memory: velocities, impulses and counts, and nothing that costs extra.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// What a sweep asks of one impact, in the chain's units.
struct BriefImpact {
  hybrid::Ending ending = hybrid::Ending::separated;
  std::string message;           ///< why, for endings other than separated; else empty
  double time = 0;               ///< of the ending [s]
  std::vector<double> velocity;  ///< n values [m/s]
  std::vector<double> impulse;   ///< n−1 values [N s]
  std::vector<Index> periods;    ///< n−1 counts of stretches in which a contact carried force
  Index events = 0;              ///< instants at which contacts closed or opened
  Index steps = 0;
  Index rhs = 0;  ///< evaluations of the right-hand side, or of its series
  /// Difference to a looser run, relative to the largest incident speed; where contacts close again and again
  std::optional<double> estimated_accuracy;
  Index widest = 0;  ///< contacts of the largest island; all of them if the chain was one system
};

/// Solves one chain after the other. After the first of its kind and size nothing is allocated. Not to be
/// shared between threads; each has its own.
class ChainSolver {
 public:
  ChainSolver();
  ~ChainSolver();
  /// As `simulate`, without peaks, balances and events; the result holds until the next call. Throws
  /// InvalidParameter for a chain, accuracy or flow that makes no sense.
  const BriefImpact& solve(const model::Chain& chain, const hybrid::Options& options = {});

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::impact
