#include "mariotte/impact/chain/chain_batch.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mariotte/flow/triplet/triplet_lanes.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/chain/triplet_scene.hpp"
#include "mariotte/impact/promise.hpp"

namespace mariotte::impact {
namespace {

constexpr auto at_once = flow::Triplets::at_once;

model::Chain empty_triplet() {
  return {.mass = std::vector<double>(3),
          .law = {contact::Hertz(1), contact::Hertz(1)},
          .gap = std::vector<double>(2),
          .velocity = std::vector<double>(3)};
}

/// The numbers of a triplet, put back.
void restore(const TripletScene& scene, model::Chain& chain) {
  std::copy_n(scene.mass, 3, chain.mass.begin());
  std::copy_n(scene.velocity, 3, chain.velocity.begin());
  for (int j = 0; j < 2; ++j) {
    chain.law[j] = contact::Hertz(scene.stiffness[j]);
    chain.gap[j] = scene.gap[j];
  }
}

constexpr double attainable = Passage{}.attainable;

Passage passage(const flow::Triplet& t) {
  return {.contacts = 2,
          .harmless = single_wave(2),
          .periods = t.periods[0] + t.periods[1],
          .steps = t.steps + t.series_steps};
}

/// Triplets that wait for each other, and where they lead.
struct Waiting {
  std::array<TripletScene, at_once> scene;
  std::array<flow::Triplet, at_once> triplet, tighter;
  std::array<Index, at_once> which;
  std::array<std::size_t, at_once> again;  ///< those that have been run again, tighter
  std::size_t count = 0;
};

}  // namespace

struct ChainBatch::Memory {
  Take take;
  ChainSolver solver;
  flow::Triplets lanes;
  Waiting all;
  NaturalRoot natural_root;
  double accuracy = 0;  ///< of those that wait
  model::Chain chain = empty_triplet();
  BriefImpact impact, looser;

  void add(Index number, const TripletScene& one, double wanted) {
    if (all.count == at_once || (all.count > 0 && wanted != accuracy)) finish();
    accuracy = wanted;
    all.which[all.count] = number;
    all.scene[all.count] = one;
    all.triplet[all.count++] = dimensionless(one, accuracy);
  }

  /// Those whose errors may have grown run again; returns the accuracy.
  double run_tighter() {
    const double finer = next_accuracy(accuracy, accuracy, std::nullopt, attainable).value_or(accuracy);
    std::size_t count = 0;
    for (std::size_t i = 0; i < all.count; ++i) {
      if (!may_have_erred(passage(all.triplet[i]))) continue;
      all.again[count] = i;
      all.tighter[count++] = dimensionless(all.scene[i], finer);
    }
    lanes.follow({all.tighter.data(), count}, finer);
    for (std::size_t k = count; k-- > 0;) all.tighter[all.again[k]] = all.tighter[k];
    return finer;
  }

  /// What the lanes have to tell of a triplet; false if that is not to be believed.
  bool describe(std::size_t i, double finer) {
    const auto& scene = all.scene[i];
    if (!impact::describe(scene, all.triplet[i], accuracy, impact)) return false;
    if (!may_have_erred(passage(all.triplet[i]))) return true;
    std::swap(impact, looser);
    if (!(finer < accuracy) || !impact::describe(scene, all.tighter[i], finer, impact)) return false;
    const double apart = difference(impact.velocity, looser.velocity, scene.speed);
    if (apart > 0) impact.estimated_accuracy = apart;
    return apart <= accuracy;
  }

  void finish() {
    lanes.follow({all.triplet.data(), all.count}, accuracy);
    const double finer = run_tighter();
    for (std::size_t i = 0; i < all.count; ++i) {
      restore(all.scene[i], chain);
      const bool is_done = describe(i, finer);
      take(all.which[i], chain, is_done ? impact : solver.solve(chain, {.accuracy = accuracy}));
    }
    all.count = 0;
  }
};

ChainBatch::ChainBatch(Take take) : memory_(std::make_unique<Memory>()) {
  memory_->take = std::move(take);
}
ChainBatch::~ChainBatch() = default;

void ChainBatch::put(Index which, const model::Chain& chain, const hybrid::Options& options) {
  auto& m = *memory_;
  model::validate(chain);
  hybrid::validate(options);
  if (const auto scene = triplet_scene(chain, options, m.natural_root))
    return m.add(which, *scene, options.accuracy);
  m.take(which, chain, m.solver.solve(chain, options));
}

void ChainBatch::finish() {
  memory_->finish();
}

}  // namespace mariotte::impact
