#include "lane_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "mariotte/impact/chain/chain_batch.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/microbody/microbody_batch.hpp"
#include "problem.hpp"

namespace mariotte::work_precision {
namespace {

using Chains = std::vector<model::Chain>;
using Spheres = std::vector<model::Microbody>;

Chains map() {
  Chains chains;
  for (const auto& one : problem("map", 1).cases) chains.push_back(std::get<model::Chain>(one.model));
  return chains;
}

/// Masses over a decade and stiffnesses over two.
class RandomRows {
 public:
  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  model::Chain touching(int balls) {
    model::Chain chain;
    for (int i = 0; i < balls; ++i) chain.mass.push_back(std::pow(10.0, uniform(-0.5, 0.5)));
    for (int j = 0; j + 1 < balls; ++j)
      chain.law.emplace_back(contact::Hertz{std::pow(10.0, uniform(-1, 1))});
    chain.gap.resize(chain.law.size());
    chain.velocity.resize(chain.mass.size());
    chain.velocity[0] = 1;
    return chain;
  }

 private:
  std::mt19937_64 random_{5};
};

/// The second contact open by up to a few indentations.
Chains with_gaps() {
  RandomRows random;
  Chains chains(4096);
  for (auto& chain : chains) {
    chain = random.touching(3);
    chain.gap[1] = random.uniform(0, 2);
    chain.velocity[2] = random.uniform(-0.5, 0.5);
  }
  return chains;
}

/// One ball strikes others that touch.
Chains cradles(int balls) {
  RandomRows random;
  Chains chains(2048);
  for (auto& chain : chains) chain = random.touching(balls);
  return chains;
}

/// Microspheres of 2.5 to 10 µm at 2 to 20 m/s, adhesive and damped; all rebound.
Spheres microspheres() {
  const contact::Surface surface{.stiffness = 1.74e9, .adhesion = 0.1};
  constexpr double density = 1350, count = 4096;
  Spheres spheres;
  for (int i = 0; i < count; ++i) {
    const double radius = 2.5e-6 * std::pow(4.0, i / count), speed = 2 + 18 * (i % 64) / 64.0;
    auto& body = spheres.emplace_back();
    body.body = model::sphere(radius, density);
    body.law = {contact::brach_dunn(surface, radius,
                                    contact::hertz_damping(0.1, surface, radius, density, speed),
                                    contact::adhesion_damping(0.1, surface, radius, density, speed))};
    body.velocity = {-speed, 0, 0};
  }
  return spheres;
}

/// How models of one kind are solved, and what is compared.
struct OfChains {
  using Model = model::Chain;
  using Solver = impact::ChainSolver;
  using Batch = impact::ChainBatch;
  static auto velocities(const impact::BriefImpact& impact) { return impact.velocity; }
};
struct OfSpheres {
  using Model = model::Microbody;
  using Solver = impact::MicrobodySolver;
  using Batch = impact::MicrobodyBatch;
  static auto velocities(const impact::BriefMicrobodyImpact& impact) {
    return std::array{impact.velocity.e1, impact.velocity.e2, impact.velocity.e3};
  }
};

/// Solves all and keeps their velocities.
template <class Kind>
class Runs {
  using Models = std::vector<typename Kind::Model>;
  using Velocities = std::vector<decltype(Kind::velocities({}))>;

 public:
  Runs(const Models& models, double accuracy)
      : models_(models), options_{.accuracy = accuracy}, alone_(models.size()), lanes_(models.size()) {}

  void one_by_one() {
    for (std::size_t i = 0; i < models_.size(); ++i)
      alone_[i] = Kind::velocities(solver_.solve(models_[i], options_));
  }
  void side_by_side() {
    for (std::size_t i = 0; i < models_.size(); ++i) batch_.put(static_cast<Index>(i), models_[i], options_);
    batch_.finish();
  }
  double difference() const {
    double most = 0;
    for (std::size_t i = 0; i < models_.size(); ++i)
      for (std::size_t k = 0; k < alone_[i].size(); ++k)
        most = std::max(most, std::abs(alone_[i][k] - lanes_[i][k]));
    return most;
  }

 private:
  const Models& models_;
  hybrid::Options options_;
  Velocities alone_, lanes_;
  typename Kind::Solver solver_;
  typename Kind::Batch batch_{[this](Index which, const auto&, const auto& impact) {
    lanes_[static_cast<std::size_t>(which)] = Kind::velocities(impact);
  }};
};

template <class Kind>
std::string line(const char* name, const std::vector<typename Kind::Model>& models, double accuracy,
                 const measuring::Patience& patience) {
  Runs<Kind> runs(models, accuracy);
  double alone = infinity, lanes = infinity;
  for (int i = 0; i <= patience.batches; ++i) {  // in turn: both see the same neighbours on the machine
    alone = std::min(alone, measuring::timed([&] { runs.one_by_one(); }));
    lanes = std::min(lanes, measuring::timed([&] { runs.side_by_side(); }));
  }
  const double unit = 1e6 / static_cast<double>(models.size());
  return fmt::format("{:<12} {:>8.0e}  {:>13.2f}  {:>15.2f}  {:>6.2f}  {:>11.1e}\n", name, accuracy,
                     unit * alone, unit * lanes, alone / lanes, runs.difference());
}

}  // namespace

std::string lane_cost(const measuring::Patience& patience) {
  std::string text = "scenes       accuracy  one by one/µs  side by side/µs   ratio   difference\n";
  const Chains of_map = map(), of_gaps = with_gaps();
  for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    text += line<OfChains>("map", of_map, accuracy, patience);
  for (const double accuracy : {1e-6, 1e-10})
    text += line<OfChains>("with gaps", of_gaps, accuracy, patience);
  for (const int balls : {4, 5, 6, 8}) {
    const Chains of_cradles = cradles(balls);
    for (const double accuracy : {1e-6, 1e-8, 1e-10})
      text += line<OfChains>(fmt::format("{} balls", balls).c_str(), of_cradles, accuracy, patience);
  }
  const Spheres spheres = microspheres();
  for (const double accuracy : {1e-6, 1e-8, 1e-10, 1e-12})
    text += line<OfSpheres>("microsphere", spheres, accuracy, patience);
  return text;
}

}  // namespace mariotte::work_precision
