// Turns looks at a run of islands into samples.
#pragma once
#include "mariotte/impact/watch/due_samplings.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"
#include "mariotte/model/islands/snapshot.hpp"

namespace mariotte::impact {

class SamplingObserver final : public model::SnapshotObserver {
 public:
  /// For a chain and what watches it, which outlive it.
  SamplingObserver(const model::DimensionlessChain& chain, const RunObserver& observers)
      : scale_(chain.scale),
        observers_(observers),
        due_(observers, chain.scale, std::ssize(chain.mass), chain.time) {}
  double next_look() const override { return due_.next(); }
  void look(model::Snapshot& run) override { due_.take_due(run.time(), run); }
  void look_last(model::Snapshot& run) override { due_.take_all(run.time(), run); }
  void passed(double time, Index events) override { tell(observers_, time * scale_.time, events); }
  bool gives_up() const override { return impact::gives_up(observers_); }

 private:
  const Scale& scale_;
  const RunObserver& observers_;
  DueSamplings due_;
};

}  // namespace mariotte::impact
