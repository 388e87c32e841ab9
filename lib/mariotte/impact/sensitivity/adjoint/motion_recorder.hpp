// What records the motion of a row as it goes.
#pragma once
#include "mariotte/flow/push_series.hpp"
#include "mariotte/impact/sensitivity/adjoint/motion_memory.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/model/islands/island.hpp"

namespace mariotte::impact {

/// Records one stretch after the other of the rows that islands follow, long ones in parts. Throws
/// InvalidParameter at a step that is no series.
class MotionRecorder final : public model::IslandObserver {
 public:
  /// Steps are divided until what is `accuracy` of the motion does not count. `memory` must outlive this.
  MotionRecorder(double accuracy, const SlopeWatch& watch, MotionMemory& memory)
      : accuracy_(accuracy), watch_(watch), memory_(memory) {}

  void begin(const model::ChainSystem& slice, Index first, Instant start) override;
  void observe(const flow::Step& step) override;
  void keep() override;

 private:
  struct Places;
  const contact::PowerLaw& law(Index number) const {
    return *power_law(slice_->chain().law[number - seen_.stretch.front().first]);
  }
  void note_closings(ConstState x);
  void begin_part(const MotionRecord::Stretch& part);
  void close_part();
  void next_part();
  /// The present part stands before the edge of the memory.
  bool is_wanted() const { return !wanted_ || seen_.stretch.front().part < *wanted_; }
  Places places(double begin, double width) const;
  void add(const flow::Step& step, double begin, double width, int halvings);
  Index number_of(Index gap) const;
  void add_contact(const flow::PushSeries::Contact& contact, const Places& places);
  bool ends(const flow::PushSeries::Contact& contact, const Nodes& depth) const;
  void drop(std::size_t contacts, std::size_t rates);
  void add_dozing(const flow::Step& step, const Places& places);
  bool is_shallow(const flow::PushSeries::Contact& contact) const;
  bool are_resolved(const MotionRecord::Piece& piece) const;

  double accuracy_;
  const SlopeWatch& watch_;
  MotionMemory& memory_;
  const model::ChainSystem* slice_ = nullptr;
  double end_ = 0;               ///< of the last step
  MotionRecord seen_;            ///< the present part of the present stretch
  MotionRecord done_;            ///< the last parts before it
  Index missing_ = 0;            ///< parts before them
  std::optional<Index> wanted_;  ///< how many of them are, if not all
  flow::PushSeries series_;
};

}  // namespace mariotte::impact
