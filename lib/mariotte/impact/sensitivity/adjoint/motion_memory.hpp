// As much of a motion as there is room for. What is missing before it is recorded by another run.
#pragma once
#include <optional>

#include "mariotte/impact/sensitivity/adjoint/motion_record.hpp"

namespace mariotte::impact {

/// The last stretches of a row, and what all of them say.
class MotionMemory {
 public:
  /// Where the parts begin that are there; `number` counts parts.
  struct Edge {
    Index number;
    MotionRecord::Stretch stretch;
  };

  /// How much has been recorded, whether it is there or not.
  struct Progress {
    Index parts = 0;
    std::size_t bytes = 0;
  };

  /// Of all parts.
  MotionMemory(Index contacts, std::size_t most_bytes);
  /// Of the parts before an edge, recorded by a run that goes on after those `before`.
  MotionMemory(Index contacts, std::size_t most_bytes, const Edge& until, const Progress& before);

  /// The next stretch, of which the first `missing` parts have been left out.
  void add(Index missing, const MotionRecord& parts);
  /// How many parts of a stretch stand before the edge, if that is within it.
  std::optional<Index> wanted(const MotionRecord::Stretch& stretch) const;

  const MotionRecord& motion() const { return motion_; }
  const Progress& progress() const { return progress_; }
  /// All parts before the edge have been seen.
  bool is_complete() const { return until_ && progress_.parts >= until_->number; }
  /// If something has been left out.
  std::optional<Edge> edge() const;
  std::size_t most_bytes() const { return most_bytes_; }
  /// By contact: it was taken into an island that was there, for a wave came to it.
  const std::vector<char>& waiting() const { return waiting_; }

 private:
  void note_waiting(const MotionRecord::Stretch& last_part);

  std::size_t most_bytes_;
  std::optional<Edge> until_;
  Index first_ = 0;  ///< number of the first part that is there
  Progress progress_;
  MotionRecord motion_;
  std::vector<char> seen_, waiting_;  ///< by contact
  std::vector<Instant> left_;         ///< by ball: end of the last stretch
};

}  // namespace mariotte::impact
