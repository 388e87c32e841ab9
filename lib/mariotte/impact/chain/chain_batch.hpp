// Many chains at once: those that are alike side by side, one in each lane of a register.
#pragma once
#include <functional>
#include <memory>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::impact {

/// Solves chains as ChainSolver does, in any order. What a chain gives does not depend on the others. After
/// the first of their kinds and sizes nothing is allocated. Not to be shared between threads; each has its
/// own.
class ChainBatch {
 public:
  /// Takes the result of a chain, and the number by which it was put in; both hold during the call. The chain
  /// has the numbers that were put in.
  using Take = std::function<void(Index which, const model::Chain& chain, const BriefImpact& impact)>;

  explicit ChainBatch(Take take);
  ~ChainBatch();
  /// Its result is taken now, later, or by `finish`. Throws InvalidParameter for a chain, accuracy or flow
  /// that makes no sense; those before it are not affected.
  void put(Index which, const model::Chain& chain, const hybrid::Options& options);
  /// Takes the results of all that were put in.
  void finish();

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::impact
