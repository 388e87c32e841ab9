// States of a row on its way, from which what has not been kept of its motion is recorded again.
#pragma once
#include <cstddef>
#include <map>

#include "mariotte/impact/sensitivity/adjoint/motion_memory.hpp"
#include "mariotte/model/islands/islands.hpp"

namespace mariotte::impact {

/// A state, and how much of the motion had been recorded before it.
struct MotionCheckpoint {
  MotionMemory::Progress before;
  model::Checkpoint state;
};

/// As many as there is room for, nearly evenly along the record.
class Checkpoints {
 public:
  explicit Checkpoints(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  void add(MotionCheckpoint&& one);
  /// The last before part `number` of the record, or null. Those behind it are forgotten.
  const MotionCheckpoint* last_before(Index number);
  std::size_t bytes() const { return bytes_; }

 private:
  using ByParts = std::map<Index, MotionCheckpoint>;
  void erase(ByParts::iterator one);
  ByParts::iterator least_missed();

  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  ByParts all_;  ///< by the parts before each
};

/// Adds a state whenever so much has been recorded that half a memory is filled, and gives a run up when all
/// that its memory wants has been seen.
class CheckpointObserver final : public model::SnapshotObserver {
 public:
  CheckpointObserver(const model::Islands& run, const MotionMemory& memory, Checkpoints& checkpoints)
      : run_(run), memory_(memory), checkpoints_(checkpoints), last_(memory.progress()) {}

  double next_look() const override { return infinity; }
  void look(model::Snapshot&) override {}
  void look_last(model::Snapshot&) override {}
  void passed(double, Index) override;
  bool gives_up() const override { return memory_.is_complete(); }

 private:
  const model::Islands& run_;
  const MotionMemory& memory_;
  Checkpoints& checkpoints_;
  MotionMemory::Progress last_;  ///< at the last state
};

}  // namespace mariotte::impact
