#include "mariotte/impact/microbody/microbody_batch.hpp"

#include <utility>

#include "mariotte/impact/lane_batch.hpp"
#include "mariotte/impact/microbody/sphere_runs.hpp"

namespace mariotte::impact {
namespace {

struct MicrobodyLanes : SphereRuns {
  using Model = model::Microbody;
  using Impact = BriefMicrobodyImpact;
  using Solver = MicrobodySolver;

  static std::optional<SphereScene> scene_of(const Model& body, const hybrid::Options& options,
                                             NaturalRoot& natural_root) {
    return sphere_scene(body, options, natural_root);
  }
  static Model any_model() {
    Model body{};
    body.body.tips.resize(1);
    body.law.resize(1);
    return body;
  }
};

}  // namespace

struct MicrobodyBatch::Memory : LaneBatch<MicrobodyLanes> {
  using LaneBatch::LaneBatch;
};

MicrobodyBatch::MicrobodyBatch(Take take) : memory_(std::make_unique<Memory>(std::move(take))) {}
MicrobodyBatch::~MicrobodyBatch() = default;

void MicrobodyBatch::put(Index which, const model::Microbody& body, const hybrid::Options& options) {
  memory_->put(which, body, options);
}

void MicrobodyBatch::finish() {
  memory_->finish();
}

}  // namespace mariotte::impact
