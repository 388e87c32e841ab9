// Spheres that are followed at once.
#pragma once
#include <memory>
#include <vector>

#include "mariotte/flow/sphere/sphere_lanes.hpp"
#include "mariotte/impact/microbody/sphere_scene.hpp"

namespace mariotte::impact {

/// Nothing is allocated after the first run. Not to be shared between threads; each has its own.
class SphereRuns {
 public:
  static constexpr std::size_t at_once = 256;  ///< at most: so many hardly leave a lane idle

  double accuracy() const { return accuracy_; }
  const std::vector<SphereScene>& scenes() const { return scene_; }
  /// Another one; all have the same accuracy.
  void add(const SphereScene& scene, double accuracy);
  void follow();
  /// What came out of a scene, until the next call; null if the lanes cannot tell.
  const BriefMicrobodyImpact* result(std::size_t i);
  void clear() { scene_.clear(); }

 private:
  std::unique_ptr<flow::SphereLanes> lanes_ = flow::make_sphere_lanes();
  double accuracy_ = 0;
  std::vector<SphereScene> scene_;
  flow::Sphere* sphere_[at_once];
  BriefMicrobodyImpact impact_;
};

}  // namespace mariotte::impact
