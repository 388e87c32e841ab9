#include "mariotte/impact/chain/triplet_scene.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/rough_root.hpp"
#include "mariotte/impact/gate.hpp"
#include "mariotte/impact/lane_scene.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

namespace mariotte::impact {
namespace {

constexpr double most_alike = 1e3;    ///< ratio of two masses
constexpr double farthest_gap = 1e6;  ///< over the natural length: flights beyond lose digits

bool is_hertz(const contact::Law& law) {
  const auto* power = contact::power_law(law);
  return power && power->exponent == 1.5 && power->damping == 0 && is_moderate(power->stiffness);
}

bool are_alike(const std::vector<double>& mass) {
  const double least = std::min({mass[0], mass[1], mass[2]}), largest = std::max({mass[0], mass[1], mass[2]});
  return is_moderate(least) && is_moderate(largest) && largest <= most_alike * least;
}

bool are_two_of_hertz(const model::Chain& chain) {
  return chain.mass.size() == 3 && is_hertz(chain.law[0]) && is_hertz(chain.law[1]) &&
         are_alike(chain.mass) && chain.gap[0] >= 0 && chain.gap[1] >= 0 && chain.gravity == 0 &&
         chain.drive.empty();
}

double reduced_mass(const TripletScene& scene, int j) {
  return scene.mass[j] / (1 + scene.mass[j] / scene.mass[j + 1]);
}

/// As of any chain [scaled_contacts.hpp]: the contact with the shortest natural time has the stiffness 1.
void scale(TripletScene& scene, NaturalRoot& natural_root) {
  const double slow[] = {reduced_mass(scene, 0) / scene.stiffness[0],
                         reduced_mass(scene, 1) / scene.stiffness[1]};
  const int quickest = slow[1] < slow[0];
  auto& unit = scene.scale;
  scene.unit_stiffness = scene.stiffness[quickest];
  unit.mass = power_of_two_below(2 * reduced_mass(scene, quickest));
  unit.velocity = power_of_two_below(scene.speed);
  unit.length = natural_root(unit.mass * unit.velocity * unit.velocity / scene.unit_stiffness, 1.5);
  unit.time = unit.length / unit.velocity;
}

double approach(const TripletScene& scene, int j) {
  return (scene.velocity[j] - scene.velocity[j + 1]) / scene.scale.velocity;
}

/// Dimensionless velocities before and after, and impulses, which follow from the rates: without a wall they
/// keep the momentum.
struct TripletEnd {
  double before[3], after[3], impulse[2] = {};

  TripletEnd(const TripletScene& scene, const flow::Triplet& t) {
    const double(&m)[3] = scene.mass, unit = scene.scale.mass, u[] = {unit / m[0], unit / m[1], unit / m[2]};
    const double lost[] = {approach(scene, 0) - t.rate[0], approach(scene, 1) - t.rate[1]};
    const double own[] = {u[0] + u[1], u[1] + u[2]}, all = u[0] * own[1] + u[1] * u[2];
    for (int j = 0; j < 2; ++j)
      if (t.periods[j] > 0)
        impulse[j] =
            t.periods[1 - j] > 0 ? (own[1 - j] * lost[j] + u[1] * lost[1 - j]) / all : lost[j] / own[j];
    for (int i = 0; i < 3; ++i) before[i] = scene.velocity[i] / scene.scale.velocity;
    after[0] = before[0] - u[0] * impulse[0];
    after[1] = before[1] + u[1] * (impulse[0] - impulse[1]);
    after[2] = before[2] + u[2] * impulse[1];
  }
};

/// As of any chain [chain_gate.cpp]. True if all balances close.
bool passes_gate(const TripletScene& scene, const flow::Triplet& t, const TripletEnd& end, double accuracy) {
  double momentum = 0, energy = 0, moved = 0, gained = 0;
  for (int i = 0; i < 3; ++i) {
    const double m = scene.mass[i] / scene.scale.mass, before = end.before[i], after = end.after[i];
    const double fastest = scene.speed / scene.scale.velocity + std::max(std::abs(before), std::abs(after));
    momentum += m * fastest;
    energy += m * fastest * fastest;
    moved += m * (after - before);
    gained += 0.5 * m * (after * after - before * before);
  }
  const double share = balance_allowance * std::max(accuracy, 16 * epsilon);
  const auto depth = [&](int j) { return t.indentation[j] * t.weight[j] * t.weight[j]; };
  const Balance balances[] = {
      {"an approach at the end", std::max({t.rate[0], t.rate[1], 0.0}), balance_allowance * t.noise_speed},
      {"the energy balance, in units of the run,", gained, share * energy},
      {"the momentum balance, in units of the run,", moved, share * momentum},
      {"an impulse that pulls", std::max({-end.impulse[0], -end.impulse[1], 0.0}), share * momentum},
      {"an indentation without force", std::max({depth(0), depth(1), 0.0}), share}};
  return closes(balances);
}

}  // namespace

std::optional<TripletScene> triplet_scene(const model::Chain& chain, const hybrid::Options& options,
                                          NaturalRoot& natural_root) {
  if (!are_two_of_hertz(chain) || !asks_for_accuracy_alone(options)) return std::nullopt;
  TripletScene scene{};
  std::copy_n(chain.mass.begin(), 3, scene.mass);
  std::copy_n(chain.velocity.begin(), 3, scene.velocity);
  for (int j = 0; j < 2; ++j) {
    scene.stiffness[j] = contact::power_law(chain.law[j])->stiffness;
    scene.gap[j] = chain.gap[j];
  }
  scene.speed = model::speeds(chain).largest;
  if (!is_moderate(scene.speed)) return std::nullopt;
  scale(scene, natural_root);
  return scene;
}

model::Chain any_triplet() {
  return {.mass = std::vector<double>(3),
          .law = {contact::Hertz(1), contact::Hertz(1)},
          .gap = std::vector<double>(2),
          .velocity = std::vector<double>(3)};
}

void restore(const TripletScene& scene, model::Chain& chain) {
  std::copy_n(scene.mass, 3, chain.mass.begin());
  std::copy_n(scene.velocity, 3, chain.velocity.begin());
  for (int j = 0; j < 2; ++j) {
    chain.law[j] = contact::Hertz(scene.stiffness[j]);
    chain.gap[j] = scene.gap[j];
  }
}

flow::Triplet dimensionless(const TripletScene& scene, double accuracy) {
  flow::Triplet t{};
  const auto& unit = scene.scale;
  const double speed = scene.speed / unit.velocity, noise = model::noise_share(accuracy);
  const double stiffness[] = {scene.stiffness[0] / scene.unit_stiffness,
                              scene.stiffness[1] / scene.unit_stiffness};
  t.noise_speed = noise * speed;
  t.noise_root = 2 * flow::rough_root(noise, 2.5);
  for (int j = 0; j < 2; ++j) {
    t.own[j] = stiffness[j] * (unit.mass / scene.mass[j] + unit.mass / scene.mass[j + 1]);
    t.cross[j] = stiffness[1 - j] * (unit.mass / scene.mass[1]);
    t.weight[j] = flow::rough_root(t.own[j] / (speed * speed), 5);
    t.rate[j] = approach(scene, j);
    t.indentation[j] = -scene.gap[j] / unit.length;
    t.same_instant = std::max(t.same_instant, accuracy / (speed * t.weight[j] * t.weight[j]));
    if (-t.indentation[j] * t.weight[j] * t.weight[j] > farthest_gap) t.stage = flow::TripletStage::leaves;
  }
  if (t.stage != flow::TripletStage::leaves) begin(t);
  return t;
}

bool describe(const TripletScene& scene, const flow::Triplet& t, double accuracy, BriefImpact& impact) {
  const TripletEnd end(scene, t);
  if (t.stage != flow::TripletStage::over || !passes_gate(scene, t, end, accuracy)) return false;
  impact.ending = hybrid::Ending::separated;
  impact.message.clear();
  impact.time = t.time * scene.scale.time;
  impact.velocity.resize(3);
  impact.impulse.resize(2);
  for (int i = 0; i < 3; ++i) impact.velocity[i] = end.after[i] * scene.scale.velocity;
  for (int j = 0; j < 2; ++j) impact.impulse[j] = end.impulse[j] * scene.scale.momentum();
  impact.periods.assign(t.periods, t.periods + 2);
  impact.events = t.events;
  impact.steps = impact.rhs = t.steps + t.series_steps;
  impact.estimated_accuracy.reset();
  impact.widest = 2;
  return true;
}

}  // namespace mariotte::impact
