#include "mariotte/impact/chain/chain_batch.hpp"

#include <utility>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/chain/row_runs.hpp"
#include "mariotte/impact/lane_batch.hpp"

namespace mariotte::impact {
namespace {

template <class Runs, auto scene>
struct ChainLanes : Runs {
  using Model = model::Chain;
  using Impact = BriefImpact;
  using Solver = ChainSolver;
  static auto scene_of(const Model& chain, const hybrid::Options& options, NaturalRoot& natural_root) {
    return scene(chain, options, natural_root);
  }
  static Model any_model() { return {}; }
};

}  // namespace

struct ChainBatch::Memory {
  LaneBatch<ChainLanes<TripletRuns, row_scene<3>>> triplets;
  LaneBatch<ChainLanes<ShortRowRuns, row_scene<flow::ShortRow::most + 1>>> others;

  explicit Memory(const Take& take) : triplets(take), others(take) {}
};

ChainBatch::ChainBatch(Take take) : memory_(std::make_unique<Memory>(take)) {}
ChainBatch::~ChainBatch() = default;

void ChainBatch::put(Index which, const model::Chain& chain, const hybrid::Options& options) {
  chain.mass.size() == 3 ? memory_->triplets.put(which, chain, options)
                         : memory_->others.put(which, chain, options);
}

void ChainBatch::finish() {
  memory_->triplets.finish();
  memory_->others.finish();
}

}  // namespace mariotte::impact
