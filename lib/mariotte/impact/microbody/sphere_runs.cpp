#include "mariotte/impact/microbody/sphere_runs.hpp"

#include "mariotte/flow/lanes/lane_precision.hpp"

namespace mariotte::impact {

void SphereRuns::add(const SphereScene& scene, double accuracy) {
  accuracy_ = accuracy;
  scene_.push_back(scene);
}

void SphereRuns::follow() {
  for (std::size_t i = 0; i < scene_.size(); ++i) sphere_[i] = &scene_[i].sphere;
  lanes_->follow({sphere_, scene_.size()}, flow::lane_precision(accuracy_, flow::sphere_orders));
}

const BriefMicrobodyImpact* SphereRuns::result(std::size_t i) {
  return describe(scene_[i], accuracy_, impact_) ? &impact_ : nullptr;
}

}  // namespace mariotte::impact
