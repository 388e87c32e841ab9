// Triplets that are followed at once, each to the accuracy that is promised.
#pragma once
#include <vector>

#include "mariotte/flow/triplet/triplet_lanes.hpp"
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/impact/chain/triplet_scene.hpp"

namespace mariotte::impact {

/// Nothing is allocated after the first run. Not to be shared between threads; each has its own.
class TripletRuns {
 public:
  static constexpr std::size_t at_once = flow::Triplets::at_once;  ///< at most

  explicit TripletRuns(flow::Lanewise lanewise) : lanes_(flow::make_triplet_lanes(lanewise)) {}

  double accuracy() const { return accuracy_; }
  const std::vector<TripletScene>& scenes() const { return scene_; }
  /// Another one; all have the same accuracy.
  void add(const TripletScene& scene, double accuracy);
  void follow();
  /// What came out of a scene, until the next call; null if the lanes cannot tell.
  const BriefImpact* result(std::size_t i);
  void clear();

 private:
  void follow_tighter();

  flow::Triplets lanes_;
  double accuracy_ = 0, finer_ = 0;
  std::vector<TripletScene> scene_;
  std::vector<flow::Triplet> triplet_, tighter_;
  std::vector<std::size_t> again_;  ///< those that have been run again, tighter
  BriefImpact impact_, looser_;
};

}  // namespace mariotte::impact
