// Many chains with the same memory: velocities, impulses and counts, and nothing that costs extra.
#pragma once
#include <memory>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/impact/course.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// Solves one chain after the other. After the first of its kind and size nothing is allocated. Not to be
/// shared between threads; each has its own.
class ChainSolver {
 public:
  explicit ChainSolver(Course course = Course::quickest);
  ~ChainSolver();
  /// As `simulate`, without peaks, balances and events; the result holds until the next call. Throws
  /// InvalidParameter for a chain, accuracy or flow that makes no sense.
  const BriefImpact& solve(const model::Chain& chain, const hybrid::Options& options = {});

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::impact
