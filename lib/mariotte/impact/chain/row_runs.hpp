// Short rows that are followed at once, each to the accuracy that is promised.
#pragma once
#include <utility>
#include <vector>

#include "mariotte/flow/short_row/short_row_lanes.hpp"
#include "mariotte/flow/triplet/triplet_lanes.hpp"
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/impact/chain/row_scene.hpp"

namespace mariotte::impact {

/// `Lanes` follow many `Row`s, of scenes with at most so many balls. Nothing is allocated after the first
/// run. Not to be shared between threads; each has its own.
template <int most, class Lanes, class Row>
class RowRuns {
 public:
  using Scene = RowScene<most>;
  static constexpr std::size_t at_once = Lanes::at_once;  ///< at most

  /// Of what the lanes are made.
  template <class... Of>
  explicit RowRuns(Of&&... of) : lanes_(std::forward<Of>(of)...) {}

  double accuracy() const { return accuracy_; }
  const std::vector<Scene>& scenes() const { return scene_; }
  /// Another one; all have the same accuracy.
  void add(const Scene& scene, double accuracy);
  void follow();
  /// What came out of a scene, until the next call; null if the lanes cannot tell.
  const BriefImpact* result(std::size_t i);
  void clear();

 private:
  void follow_tighter();

  Lanes lanes_;
  double accuracy_ = 0, finer_ = 0;
  std::vector<Scene> scene_;
  std::vector<Row> row_, tighter_;
  std::vector<std::size_t> again_;  ///< those that have been run again, tighter
  BriefImpact impact_, looser_;
};

using TripletRuns = RowRuns<3, flow::Triplets, flow::Triplet>;
using ShortRowRuns = RowRuns<flow::ShortRow::most + 1, flow::ShortRows, flow::ShortRow>;
extern template class RowRuns<3, flow::Triplets, flow::Triplet>;
extern template class RowRuns<flow::ShortRow::most + 1, flow::ShortRows, flow::ShortRow>;

}  // namespace mariotte::impact
