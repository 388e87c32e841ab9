// What comes out of a short row: velocities and impulses, and whether its balances close.
#pragma once
#include <algorithm>
#include <cmath>

#include "mariotte/impact/chain/row_scene.hpp"
#include "mariotte/impact/gate.hpp"

namespace mariotte::impact {

/// At the start; dimensionless.
template <int most>
double approach(const RowScene<most>& scene, int j) {
  return (scene.velocity[j] - scene.velocity[j + 1]) / scene.scale.velocity;
}

/// Dimensionless velocities before and after, and impulses. They follow from the rates: balls that contacts
/// have joined keep their momentum, since there is no wall.
template <int most>
struct RowEnd {
  double before[most], after[most], impulse[most - 1] = {};

  template <class Row>
  RowEnd(const RowScene<most>& scene, const Row& row) {
    for (int i = 0; i < scene.balls(); ++i) before[i] = scene.velocity[i] / scene.scale.velocity;
    for (int first = 0, last; first < scene.balls(); first = last + 1) {
      for (last = first; last < scene.contacts() && row.periods[last] > 0;) ++last;
      find(scene, row, first, last);
    }
  }

 private:
  /// Of balls first … last.
  template <class Row>
  void find(const RowScene<most>& scene, const Row& row, int first, int last) {
    const auto mass = [&](int i) { return scene.mass[i] / scene.scale.mass; };
    double ahead[most], all = mass(first), moment = 0;  // what a ball gains more than the first
    ahead[first] = 0;
    for (int i = first + 1; i <= last; ++i) {
      ahead[i] = ahead[i - 1] + (approach(scene, i - 1) - row.rate[i - 1]);
      all += mass(i);
      moment += mass(i) * ahead[i];
    }
    double given = 0;
    for (int i = first; i <= last; ++i) {
      const double gained = ahead[i] - moment / all;
      after[i] = before[i] + gained;
      given -= mass(i) * gained;
      if (i < last) impulse[i] = given;
    }
  }
};

/// As of any chain [chain_gate.cpp]. True if all balances close.
template <int most, class Row>
bool passes_gate(const RowScene<most>& scene, const Row& row, const RowEnd<most>& end, double accuracy) {
  double momentum = 0, energy = 0, moved = 0, gained = 0;
  for (int i = 0; i < scene.balls(); ++i) {
    const double m = scene.mass[i] / scene.scale.mass, before = end.before[i], after = end.after[i];
    const double fastest = scene.speed / scene.scale.velocity + std::max(std::abs(before), std::abs(after));
    momentum += m * fastest;
    energy += m * fastest * fastest;
    moved += m * (after - before);
    gained += 0.5 * m * (after * after - before * before);
  }
  double approaches = 0, pulls = 0, depth = 0;
  for (int j = 0; j < scene.contacts(); ++j) {
    approaches = std::max(approaches, row.rate[j]);
    pulls = std::max(pulls, -end.impulse[j]);
    depth = std::max(depth, row.indentation[j] * row.weight[j] * row.weight[j]);
  }
  const double share = balance_allowance * std::max(accuracy, 16 * epsilon);
  const Balance balances[] = {{"an approach at the end", approaches, balance_allowance * row.noise_speed},
                              {"the energy balance, in units of the run,", gained, share * energy},
                              {"the momentum balance, in units of the run,", moved, share * momentum},
                              {"an impulse that pulls", pulls, share * momentum},
                              {"an indentation without force", depth, share}};
  return closes(balances);
}

/// What came out of a row that is over, in units. False if a balance does not close.
template <int most, class Row>
bool tell(const RowScene<most>& scene, const Row& row, double accuracy, BriefImpact& impact) {
  const RowEnd<most> end(scene, row);
  if (!passes_gate(scene, row, end, accuracy)) return false;
  impact.ending = hybrid::Ending::separated;
  impact.message.clear();
  impact.time = row.time * scene.scale.time;
  impact.velocity.resize(scene.balls());
  impact.impulse.resize(scene.contacts());
  for (int i = 0; i < scene.balls(); ++i) impact.velocity[i] = end.after[i] * scene.scale.velocity;
  for (int j = 0; j < scene.contacts(); ++j) {
    const double mass = scene.mass[j] / (scene.mass[j] + scene.mass[j + 1]) * scene.mass[j + 1];
    const bool is_faint = std::abs(end.impulse[j]) * scene.scale.mass <= mass * row.noise_speed;
    impact.impulse[j] = is_faint ? 0 : end.impulse[j] * scene.scale.momentum();
  }
  impact.periods.assign(row.periods, row.periods + scene.contacts());
  impact.events = row.events;
  impact.steps = impact.rhs = row.steps + row.series_steps;
  impact.estimated_accuracy.reset();
  impact.widest = scene.contacts();
  return true;
}

}  // namespace mariotte::impact
