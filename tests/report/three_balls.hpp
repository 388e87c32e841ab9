// A result made by hand: two contacts of three balls, one of which stays closed.
#pragma once
#include <limits>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/scene/scene.hpp"

namespace support {

inline mariotte::scene::Scene three_balls() {
  mariotte::scene::Scene scene;
  scene.title = "Three balls";
  scene.model = mariotte::model::Chain{
      .mass = {1, 1, mariotte::infinity},
      .law = {mariotte::contact::Hertz{1}, mariotte::contact::Viscoelastic{4, 0.1, 1.5}},
      .gap = {0, 0},
      .velocity = {1, 0, 0}};
  scene.radius = {0.01, 0.02, mariotte::infinity};
  scene.sha256 = "0123";
  return scene;
}

inline mariotte::impact::ChainImpact three_balls_impact() {
  mariotte::impact::ChainImpact impact;
  impact.ending = mariotte::hybrid::Ending::time_limit;
  impact.message = "the time limit of 4 s was reached";
  impact.time = 4;
  impact.velocity = {0.1, 0.2, 0};
  impact.gap = {0.5, -1e-3};
  impact.contacts = {
      {.impulse = 0.9,
       .peak_force = 1.5,
       .peak_indentation = 0.75,
       .periods = {{0, 3.0}},
       .meeting = {1.0, 0.5}},
      {.impulse = 0.7, .stored = 0.25, .dissipated = 0.125, .periods = {{0.5, {}}}, .meeting = {}}};
  impact.icr = {std::nullopt};
  impact.impulse_direction = {0.8, 0.6};
  impact.events = {{.time = 0, .open = {}, .close = {0}}, {.time = 0.5, .open = {0}, .close = {1}}};
  impact.energy.initial = 0.5;
  impact.energy.final = 0.125;
  impact.energy.stored = 0.25;
  impact.energy.dissipated = 0.125;
  impact.energy.residual = 1e-17;
  impact.momentum = {.initial = 1, .final = 0.3, .residual = -2e-17};
  impact.flows = {{.name = "cvode-adams", .phases = 2, .steps = 31, .rhs = 384}};
  impact.skipped = {{.what = "mass matrix", .why = "balls on a line need none"}};
  impact.requested_accuracy = 1e-10;
  return impact;
}

}  // namespace support
