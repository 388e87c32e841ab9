// Many microbodies at once: those that are alike side by side, one in each lane of a register.
#pragma once
#include <functional>
#include <memory>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/model/microbody/microbody.hpp"

namespace mariotte::impact {

/// Solves microbodies as MicrobodySolver does, in any order; ChainBatch says more.
class MicrobodyBatch {
 public:
  /// Takes the result of a body, and the number by which it was put in; both hold during the call. The body
  /// has the numbers that were put in.
  using Take =
      std::function<void(Index which, const model::Microbody& body, const BriefMicrobodyImpact& impact)>;

  explicit MicrobodyBatch(Take take);
  ~MicrobodyBatch();
  /// Its result is taken now, later, or by `finish`. Throws InvalidParameter for a body, accuracy or flow
  /// that makes no sense; those before it are not affected.
  void put(Index which, const model::Microbody& body, const hybrid::Options& options);
  /// Takes the results of all that were put in.
  void finish();

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::impact
