#include "lane_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mariotte/impact/chain/chain_batch.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "problem.hpp"

namespace mariotte::work_precision {
namespace {

using Chains = std::vector<model::Chain>;
using Velocities = std::vector<std::vector<double>>;

Chains map() {
  Chains chains;
  for (const auto& one : problem("map", 1).cases) chains.push_back(std::get<model::Chain>(one.model));
  return chains;
}

/// Masses over a decade and stiffnesses over two, the second contact open by up to a few indentations.
Chains with_gaps() {
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  Chains chains(4096);
  for (auto& chain : chains) {
    for (int i = 0; i < 3; ++i) chain.mass.push_back(std::pow(10.0, uniform(-0.5, 0.5)));
    for (int j = 0; j < 2; ++j) chain.law.emplace_back(contact::Hertz{std::pow(10.0, uniform(-1, 1))});
    chain.gap = {0, uniform(0, 2)};
    chain.velocity = {1, 0, uniform(-0.5, 0.5)};
  }
  return chains;
}

/// Solves all and keeps their velocities.
class Runs {
 public:
  Runs(const Chains& chains, double accuracy)
      : chains_(chains), options_{.accuracy = accuracy}, alone_(chains.size()), lanes_(chains.size()) {}

  void one_by_one() {
    for (std::size_t i = 0; i < chains_.size(); ++i) alone_[i] = solver_.solve(chains_[i], options_).velocity;
  }
  void side_by_side() {
    for (std::size_t i = 0; i < chains_.size(); ++i) batch_.put(static_cast<Index>(i), chains_[i], options_);
    batch_.finish();
  }
  double difference() const {
    double most = 0;
    for (std::size_t i = 0; i < chains_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(alone_[i][k] - lanes_[i][k]));
    return most;
  }

 private:
  const Chains& chains_;
  hybrid::Options options_;
  Velocities alone_, lanes_;
  impact::ChainSolver solver_;
  impact::ChainBatch batch_{[this](Index which, const auto&, const impact::BriefImpact& impact) {
    lanes_[static_cast<std::size_t>(which)] = impact.velocity;
  }};
};

std::string line(const char* name, const Chains& chains, double accuracy,
                 const measuring::Patience& patience) {
  Runs runs(chains, accuracy);
  double alone = infinity, lanes = infinity;
  for (int i = 0; i <= patience.batches; ++i) {  // in turn: both see the same neighbours on the machine
    alone = std::min(alone, measuring::timed([&] { runs.one_by_one(); }));
    lanes = std::min(lanes, measuring::timed([&] { runs.side_by_side(); }));
  }
  const double unit = 1e6 / static_cast<double>(chains.size());
  return fmt::format("{:<12} {:>8.0e}  {:>13.2f}  {:>15.2f}  {:>6.2f}  {:>11.1e}\n", name, accuracy,
                     unit * alone, unit * lanes, alone / lanes, runs.difference());
}

}  // namespace

std::string lane_cost(const measuring::Patience& patience) {
  std::string text = "triplets     accuracy  one by one/µs  side by side/µs   ratio   difference\n";
  const Chains of_map = map(), of_gaps = with_gaps();
  for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    text += line("map", of_map, accuracy, patience);
  for (const double accuracy : {1e-6, 1e-10}) text += line("with gaps", of_gaps, accuracy, patience);
  return text;
}

}  // namespace mariotte::work_precision
