#include "mariotte/impact/chain/chain_batch.hpp"

#include <utility>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/chain/triplet_runs.hpp"
#include "mariotte/impact/lane_batch.hpp"

namespace mariotte::impact {
namespace {

struct ChainLanes : TripletRuns {
  using Model = model::Chain;
  using Impact = BriefImpact;
  using Solver = ChainSolver;
  static std::optional<TripletScene> scene_of(const Model& chain, const hybrid::Options& options,
                                              NaturalRoot& natural_root) {
    return triplet_scene(chain, options, natural_root);
  }
  static Model any_model() { return any_triplet(); }

  ChainLanes() : TripletRuns(flow::Lanewise::scenes) {}
};

}  // namespace

struct ChainBatch::Memory : LaneBatch<ChainLanes> {
  using LaneBatch::LaneBatch;
};

ChainBatch::ChainBatch(Take take) : memory_(std::make_unique<Memory>(std::move(take))) {}
ChainBatch::~ChainBatch() = default;

void ChainBatch::put(Index which, const model::Chain& chain, const hybrid::Options& options) {
  memory_->put(which, chain, options);
}

void ChainBatch::finish() {
  memory_->finish();
}

}  // namespace mariotte::impact
