#include "run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "group_units.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "measuring/timing.hpp"
#include "peaks.hpp"

namespace mariotte::stress_study {
namespace {

/// Velocities less what gravity has given to the balls since the start, which does not depend on when a run
/// ended.
std::vector<double> without_gravity(const model::Chain& chain, const std::vector<double>& velocity,
                                    double time) {
  auto values = velocity;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(chain.mass[i])) values[i] += chain.gravity * time;
  return values;
}

/// Σ m of what can move.
double moving_mass(const model::Chain& chain) {
  double sum = 0;
  for (const double mass : chain.mass)
    if (std::isfinite(mass)) sum += mass;
  return sum;
}

double imbalance(const impact::ContactImpact& impact, double energy) {
  double worst = std::abs(impact.energy.residual);
  for (const auto& contact : impact.contacts) worst = std::max(worst, -contact.dissipated);
  return worst / energy;
}

void add_contacts(const impact::ContactImpact& impact, double momentum, Found& found) {
  for (const auto& contact : impact.contacts) {
    found.periods.push_back(std::ssize(contact.periods));
    found.impulse.push_back(contact.impulse / momentum);
  }
}

template <class Impact>
void add_ending(const Impact& impact, Found& found) {
  found.ending = impact.ending;
  found.message = impact.message;
  found.estimate = impact.estimated_accuracy.value_or(0);
  if constexpr (requires { impact.rhs; })
    found.work = impact.rhs;
  else
    for (const auto& flow : impact.flows) found.work += flow.rhs;
}

void run(const model::Chain& chain, const hybrid::Options& options, bool balances, double speed,
         Found& found) {
  static impact::ChainSolver solver;
  if (!balances) {
    const auto& impact = solver.solve(chain, options);
    add_ending(impact, found);
    found.time = impact.time;
    found.value = without_gravity(chain, impact.velocity, impact.time);
    found.periods = impact.periods;
    for (const double p : impact.impulse) found.impulse.push_back(p / (moving_mass(chain) * speed));
    return;
  }
  const auto impact = impact::simulate(chain, options);
  add_ending(impact, found);
  found.time = impact.time;
  found.value = without_gravity(chain, impact.velocity, impact.time);
  add_contacts(impact, moving_mass(chain) * speed, found);
  double fastest = speed;
  for (const double v : impact.velocity) fastest = std::max(fastest, std::abs(v));
  found.imbalance = imbalance(impact, moving_mass(chain) * speed * fastest);
  found.peak_misfit = peak_misfit(impact.contacts, [&](std::size_t j) { return chain.law[j]; });
}

void run(const model::Network& network, const hybrid::Options& options, bool, double speed, Found& found) {
  const auto impact = impact::simulate(network, options);
  add_ending(impact, found);
  found.time = impact.time;
  for (const auto& direction : network.direction) found.value.push_back(gap_rate(direction, impact.velocity));
  const double energy = impact.energy.initial + std::abs(impact.energy.work);
  add_contacts(impact, energy / speed, found);
  found.imbalance = std::max(energy > 0 ? imbalance(impact, energy) : 0.0, impact.momentum_residual);
  found.peak_misfit = peak_misfit(impact.contacts, [&](std::size_t j) { return network.law[j]; });
}

void add_motion(const Body& scene, const Vector3& velocity, const Vector3& spin, Found& found) {
  const auto& tip = scene.body.body.tips[0];
  const double reach = norm(tip.centre) + tip.radius;
  found.value = {velocity.e1 + scene.body.gravity * found.time,
                 velocity.e2,
                 velocity.e3,
                 reach * spin.e1,
                 reach * spin.e2,
                 reach * spin.e3};
}

/// What the body brings, and what the wells of its tips give to it.
double energy_at_stake(const Body& scene, double initial) {
  double energy = initial;
  for (const auto& law : scene.body.law)
    energy -= contact::stored_energy(law, contact::rest_indentation(law));
  return energy;
}

void run(const Body& scene, const hybrid::Options& options, bool balances, double, Found& found) {
  static impact::MicrobodySolver solver;
  if (!balances) {
    const auto& impact = solver.solve(scene.body, options);
    add_ending(impact, found);
    found.time = impact.time;
    add_motion(scene, impact.velocity, impact.spin, found);
    return;
  }
  const auto impact = impact::simulate(scene.body, options);
  add_ending(impact, found);
  found.time = impact.final.time;
  add_motion(scene, impact.final.velocity, impact.final.spin, found);
  const auto& energy = impact.energy;
  const double losses = std::min({energy.hertz_damping, energy.adhesion_damping, energy.friction});
  found.imbalance = std::max(std::abs(energy.residual), -losses) / energy_at_stake(scene, energy.initial);
}

void run(const Group& scene, const hybrid::Options& options, bool, double speed, Found& found) {
  const auto& bodies = scene.bodies;
  const auto impact = impact::simulate(bodies, options);
  add_ending(impact, found);
  found.time = impact.time;
  double mass = 0;
  for (std::size_t i = 0; i < bodies.body.size(); ++i) {
    add_motion(scene, i, impact.body[i].velocity, impact.body[i].spin, found);
    mass += bodies.body[i].mass;
  }
  found.periods.assign(bodies.contact.size(), 0);
  found.impulse.assign(bodies.contact.size(), 0);
  double gained = std::abs(impact.energy.residual);
  for (const auto& contact : impact.contacts) {
    found.periods[static_cast<std::size_t>(contact.contact)] = std::ssize(contact.periods);
    found.impulse[static_cast<std::size_t>(contact.contact)] = contact.normal_impulse / (mass * speed);
    gained = std::max({gained, -contact.losses.friction, -contact.losses.rescale, -contact.losses.damper});
  }
  found.imbalance = gained / (mass * speed * speed + std::abs(impact.energy.work));
  found.peak_misfit = peak_misfit(impact.contacts, [&](std::size_t k) {
    return bodies.contact[static_cast<std::size_t>(impact.contacts[k].contact)].law;
  });
}

}  // namespace

void add_motion(const Group& scene, std::size_t body, const Vector3& velocity, const Vector3& spin,
                Found& found) {
  const Vector3 v = velocity - found.time * scene.bodies.gravity, w = reach(scene.bodies.body[body]) * spin;
  found.value.insert(found.value.end(), {v.e1, v.e2, v.e3, w.e1, w.e2, w.e3});
}

std::string name(const Method& method) {
  return fmt::format("{} at {:.0e}", method.flow, method.accuracy);
}

Found run(const Scene& scene, const Method& method) {
  Found found;
  const double start = measuring::cpu_seconds(), speed = reference_speed(scene.model);
  const hybrid::Options options{.accuracy = method.accuracy,
                                .max_time = scene.max_time,
                                .max_events = most_events,
                                .flow = flow::parse_kind(method.flow)};
  try {
    std::visit([&](const auto& model) { run(model, options, method.balances, speed, found); }, scene.model);
  } catch (const InvalidParameter& problem) {
    found = {.message = problem.what(), .refused = true};
  } catch (const std::exception& problem) {
    found = {.message = std::string("exception: ") + problem.what()};
  }
  for (double& value : found.value) {
    value /= speed;
    found.rounding = std::max(found.rounding, 8 * epsilon * std::abs(value));
  }
  found.seconds = measuring::cpu_seconds() - start;
  return found;
}

double distance(const Found& one, const Found& other) {
  if (one.value.size() != other.value.size() || one.value.empty()) return infinity;
  double most = 0;
  for (std::size_t i = 0; i < one.value.size(); ++i) {
    const double difference = std::abs(one.value[i] - other.value[i]);
    most = difference <= most ? most : difference;  // what is not a number stays
  }
  return std::isnan(most) ? infinity : most;
}

}  // namespace mariotte::stress_study
