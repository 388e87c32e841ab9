// One phase of each kind that models have, for the tests of flows.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/flow/choose.hpp"
#include "mariotte/model/chain/chain_system.hpp"
#include "mariotte/model/microbody/microbody_system.hpp"
#include "mariotte/model/network/network_system.hpp"
#include "support/linear_chains.hpp"
#include "support/networks.hpp"
#include "support/reference.hpp"
#include "support/reference_bodies.hpp"

namespace mariotte::test {

/// A system at the start of its first phase.
struct Phase {
  std::shared_ptr<void> system;
  std::vector<double> x;
  flow::Problem* problem;  ///< of the system
};

/// A phase, and the flows that follow it beside those of any field.
struct PhaseCase {
  std::string name;
  std::vector<flow::Kind> special;
  std::function<Phase()> make;
};

/// The accuracy that systems are made for: what is noise to them.
inline constexpr double phase_accuracy = 1e-12;

template <class System>
Phase first_phase(std::shared_ptr<System> system, std::vector<double> x) {
  auto mode = std::make_shared<typename System::Mode>();
  std::vector<typename System::Change> changes;
  system->mode_at(x, *mode, changes);
  auto& problem = system->problem(*mode);
  return {std::make_shared<std::pair<decltype(system), decltype(mode)>>(system, mode), std::move(x),
          &problem};
}

inline Phase phase_of(const model::Chain& chain) {
  auto system = std::make_shared<model::ChainSystem>();
  system->reset(chain, phase_accuracy, false);
  std::vector<double> x;
  initial_state(system->chain(), system->layout(), x);
  return first_phase(system, x);
}

inline Phase phase_of(const model::Network& network) {
  const auto system = std::make_shared<model::NetworkSystem>(network, phase_accuracy);
  std::vector<double> x;
  initial_state(system->network(), system->layout(), x);
  return first_phase(system, x);
}

/// With the first tip `height` above the plane, in units of the body.
inline Phase phase_of(const model::Microbody& body, double height = 0) {
  const auto system = std::make_shared<model::MicrobodySystem>(body, phase_accuracy, true);
  auto x = initial_state(system->body(), system->layout());
  for (const Index gap : system->layout().place.gap)
    if (gap >= 0) x[gap] += height;
  return first_phase(system, x);
}

/// A body of [Cheng 2002]: a sphere along the normal, or a tilted rod.
inline model::Microbody striking(double tilt, const Vector3& velocity, const Vector3& spin, double friction) {
  constexpr double radius = 2.45e-6;
  model::Microbody body;
  body.body = tilt == 0 ? model::sphere(radius, density) : model::rod(radius, 4, density);
  body.law.assign(body.body.tips.size(), contact::brach_dunn(table_1, radius, 0.007, 0.0087));
  body.friction = {friction};
  body.attitude = from_euler({0, tilt, 0});
  body.velocity = velocity;
  body.spin = spin;
  return body;
}

inline std::vector<PhaseCase> chain_phases() {
  using enum flow::Kind;
  const contact::Hertz hertz{1}, stiff{2};
  const contact::Linear soft{1}, hard{3};
  const contact::Viscoelastic lossy{.stiffness = 1, .damping = 0.2, .exponent = 1.5};
  const auto yielding = contact::state(contact::WaltonBraun(1, 2)),
             sticky = contact::state(contact::Jkr(1, 1, 0.003, 0.1));
  const contact::Law growing = std::make_shared<contact::HuntCrossley>(1, 0.2),
                     growing_line = std::make_shared<contact::HuntCrossley>(1, 0.2, 1),
                     even = std::make_shared<contact::Tsuji>(1, 0.2);
  const auto of = [](model::Chain chain, std::vector<double> gap = {}, double gravity = 0) {
    if (!gap.empty()) chain.gap = gap;
    chain.gravity = gravity;
    return [chain] { return phase_of(chain); };
  };
  auto floor = equal_masses({hertz}, {0, 0}), thrown = equal_masses({hertz}, {0, 1});
  floor.mass[0] = thrown.mass[0] = infinity;
  return {
      {"free fall", {ballistic, taylor}, of(floor, {1}, 1)},
      {"throw from the floor", {ballistic, taylor}, of(thrown, {0}, 1)},
      {"straight flight", {ballistic, taylor}, of(equal_masses({hertz, hertz}, {1, 0, -0.5}), {1, 2})},
      {"Hertz pair", {pair, taylor}, of(equal_masses({hertz}, {1, 0}))},
      {"damped pair", {pair, modal, taylor}, of(equal_masses({damper(1, 0.3)}, {1, 0}))},
      {"pair struck by a third", {pair, taylor}, of(equal_masses({hertz, hertz}, {1, 0, -1}), {0, 0.5})},
      {"linear row", {modal, taylor}, of(equal_masses({soft, hard, soft}, {1, 0.2, 0, -0.7}))},
      {"damped linear row",
       {modal, taylor},
       of(equal_masses({damper(1, 0.3), damper(3, 0.1)}, {1, 0, -0.7}))},
      {"Hertz row", {taylor}, of(equal_masses({hertz, stiff}, {1, 0, -0.7}))},
      {"damped Hertz row", {taylor}, of(equal_masses({lossy, lossy}, {1, 0, -0.7}))},
      {"pair of Hunt and Crossley", {taylor}, of(equal_masses({growing_line}, {1, 0}))},
      {"row of Hunt and Crossley", {taylor}, of(equal_masses({growing, growing}, {1, 0, -0.7}))},
      {"row of Tsuji", {taylor}, of(equal_masses({even, even}, {1, 0, -0.7}))},
      {"row of all dampers",
       {taylor},
       of(equal_masses({even, growing, lossy, soft}, {1, 0.8, 0.2, 0, -0.7}))},
      {"linear row struck from both sides", {modal, taylor}, of(equal_masses({soft, soft}, {1, 0, -1}))},
      {"Hertz row struck from both sides", {taylor}, of(equal_masses({hertz, hertz}, {1, 0, -1}))},
      {"row of two springs", {taylor}, of(equal_masses({yielding, yielding}, {1, 0, -0.7}))},
      {"adhesive row", {taylor}, of(equal_masses({sticky, sticky}, {1, 0, -0.7}))},
  };
}

/// Two disks strike a third at rest from two sides.
inline model::Network two_on_one() {
  const std::vector<model::Ball> balls = {
      {{-1, 0}, {1, 0}, 1, 0.5}, {{0, 0}, {0, 0}, 1, 0.5}, {{0.5, std::sqrt(3.0) / 2}, {-0.4, -0.3}, 1, 0.5}};
  return model::ball_network(balls, 0.1, hertz_of_pair);
}

inline std::vector<PhaseCase> other_phases() {
  using enum flow::Kind;
  const Vector3 rest{};
  const auto of = [](const contact::Law& law) {
    return [law] { return phase_of(with_law(two_on_one(), law)); };
  };
  return {
      {"linear network", {modal, taylor}, of(contact::Linear{1})},
      {"damped linear network", {modal, taylor}, of(damper(1, 0.3))},
      {"Hertz network", {taylor}, of(contact::Hertz{1})},
      {"network of Hunt and Crossley", {taylor}, of(std::make_shared<contact::HuntCrossley>(1, 0.2))},
      {"network of Tsuji", {taylor}, of(std::make_shared<contact::Tsuji>(1, 0.2))},
      {"sphere",
       {taylor},
       [=] {
         return phase_of(striking(0, {-5, 0, 0}, rest, 0));
       }},
      {"rod in a plane",
       {taylor},
       [=] {
         return phase_of(striking(0.7, {-5, 0, 1}, rest, 0.2));
       }},
      {"rod in space",
       {taylor},
       [] {
         return phase_of(striking(0.7, {-5, 1, 1}, {1e5, 2e5, 1e5}, 0.15));
       }},
      {"falling rod",
       {ballistic},
       [] {
         return phase_of(striking(0.7, {-5, 1, 1}, {1e5, 2e5, 1e5}, 0.15), 2);
       }},
  };
}

inline std::vector<PhaseCase> all_phases() {
  auto all = chain_phases();
  for (auto& one : other_phases()) all.push_back(one);
  return all;
}

}  // namespace mariotte::test
