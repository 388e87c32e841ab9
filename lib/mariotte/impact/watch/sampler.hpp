// Turns looks at a run of islands into samples.
#pragma once
#include <vector>

#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"
#include "mariotte/model/islands/snapshot.hpp"

namespace mariotte::impact {

/// All samplings of a run, each at its own times.
class SamplingObserver final : public model::SnapshotObserver {
 public:
  /// For a chain and what watches it, which outlive it.
  SamplingObserver(const model::DimensionlessChain& chain, const RunObserver& observers);
  double next_look() const override;
  void look(model::Snapshot& run) override;
  void look_last(model::Snapshot& run) override;
  void passed(double time, Index events) override;

 private:
  void take(model::Snapshot& run, std::size_t which);

  const model::DimensionlessChain& chain_;
  const RunObserver& observers_;
  std::vector<Instant> next_;  ///< of each sampling
  Sample sample_;
};

}  // namespace mariotte::impact
