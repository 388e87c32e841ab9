// The compiled field of one contact of balls beside that of any bodies: two ways to one motion.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/flow/balls/ball_expansions.hpp"
#include "mariotte/model/bodies/bodies_phase.hpp"
#include "support/random_balls.hpp"

using namespace mariotte;
using namespace mariotte::test;
using flow::BallMotion;
using model::Friction;
using model::TangentialLaw;

namespace {

model::Bodies scene(bool pair, TangentialLaw law) {
  model::Bodies bodies{.dimension = 2, .gravity = {in(-300, 300), in(-300, 300), 0}};
  bodies.body = {ball({0, 2.001 * radius, 0})};
  if (pair) bodies.body.push_back(ball({}));
  bodies.body.push_back(ball({0.1, 0.1, 0}));
  if (!pair)
    bodies.plane = {{.name = "", .point = {0, radius, 0}, .normal = {0, 1, 0}, .velocity = {0.3, 0.1, 0}}};
  const model::Feature under = pair ? model::Feature{1, 0} : model::Feature{0, -1};
  bodies.contact = {{.a = under,
                     .b = {0, 0},
                     .law = contact::Hertz(1e9),
                     .tangential = {law, 0.3, 0.8e9},
                     .share = in(0, 1)}};
  return bodies;
}

/// A state in which the ball has sunk, and turned.
std::vector<double> inside(const model::Bodies& bodies, const model::BodiesSetting<2>& setting,
                           const model::BodiesLayout<2>& at) {
  auto x = initial_state(bodies, setting);
  x.resize(at.size(), 0.0);
  x[at.shift(0)] = in(-1e-4, 1e-4);
  x[at.shift(0) + 1] = -0.001 * radius - in(1e-5, 1e-4);
  x[at.turn(0)] = in(-0.1, 0.1);
  x[at.clock()] = 1e-6;
  return x;
}

model::BodiesMode mode_of(Friction friction, bool unloading, double sign) {
  model::BodiesMode mode;
  mode.closed = {
      {.contact = 0, .slot = 0, .friction = friction, .unloading = unloading, .sign = sign, .start = {}}};
  mode.totals.resize(1);
  return mode;
}

/// Largest difference of the two rates over the size of each component.
double difference(bool pair, TangentialLaw law, const model::BodiesMode& mode) {
  const auto bodies = scene(pair, law);
  const auto setting = model::setting_of<2>(bodies, 1e-10);
  model::BodiesPhase<2> phase(setting, 0);
  phase.bind(mode);
  auto& balls = *phase.recorded()->balls();
  auto x = inside(bodies, setting, phase.layout());
  const bool as_force = mode.closed[0].friction == Friction::stick && law == TangentialLaw::mindlin;
  if (as_force) x[phase.layout().spring(0)] = mode.closed[0].unloading ? in(-1e-6, 1e-6) : in(-10, 10);
  std::vector<double> rates(x.size()), low(x.size()), high(x.size());
  phase.derivative(x, rates);
  const auto start = balls.begin(x, false);
  const auto series = flow::make_ball_expansions();
  series->expand(balls.contact(), start, 1);
  const double small = 1e-4 * phase.time_scale() / start[BallMotion::root];
  const auto moved = [&](double by, std::vector<double>& to) {
    auto motion = start;
    for (int i = 0; i < BallMotion::states; ++i) motion[i] += by * (*series)[i][1];
    balls.move(x, motion, to);
  };
  moved(-small, low);
  moved(small, high);
  const auto magnitude = phase.magnitudes();
  double most = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double slope = (high[i] - low[i]) / (2 * small * start[BallMotion::root]);
    most = std::max(most, std::abs(slope - rates[i]) * phase.time_scale() / magnitude[i]);
  }
  return most;
}

/// Largest difference of the terms of two expansions, over the sum of the terms of their row.
double apart(const flow::BallExpansions& a, const flow::BallExpansions& b, int order, double place) {
  double most = 0;
  for (int i = 0; i < BallMotion::rows; ++i) {
    double size = 0, difference = 0, power = 1;
    for (int k = 0; k <= order; ++k, power *= place) {
      size += std::abs(a[i][k]) * power;
      difference = std::max(difference, std::abs(a[i][k] - b[i][k]) * power);
    }
    if (size > 0) most = std::max(most, difference / size);
  }
  return most;
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_instruction_sets_expand_alike) {
  constexpr int order = 18;
  const auto best = flow::make_ball_expansions(), baseline = flow::baseline::make_ball_expansions();
  for (const bool pair : {false, true})
    for (const auto law : {TangentialLaw::none, TangentialLaw::rigid, TangentialLaw::mindlin})
      for (const auto friction : {Friction::stick, Friction::slip})
        for (const bool unloading : {false, true}) {
          const auto bodies = scene(pair, law);
          const auto setting = model::setting_of<2>(bodies, 1e-10);
          const auto mode = mode_of(law == TangentialLaw::none ? Friction::none : friction, unloading, 1);
          model::BodiesPhase<2> phase(setting, 0);
          phase.bind(mode);
          auto& balls = *phase.recorded()->balls();
          const auto start = balls.begin(inside(bodies, setting, phase.layout()), false);
          const double place = 0.1 * phase.time_scale() / start[BallMotion::root];
          for (const auto* one : {&best, &baseline}) (*one)->expand(balls.contact(), start, order);
          BOOST_TEST_CONTEXT(name(law) << (pair ? ", pair" : "") << (unloading ? ", unloading" : ""))
          BOOST_TEST(apart(*best, *baseline, order, place) < 1e-13);
        }
}

BOOST_AUTO_TEST_CASE(compiled_fields_are_those_of_any_bodies) {
  for (const bool pair : {false, true})
    for (const auto law : {TangentialLaw::none, TangentialLaw::rigid, TangentialLaw::mindlin})
      for (const auto friction : {Friction::stick, Friction::slip})
        for (const bool unloading : {false, true})
          for (const double sign : {-1.0, 1.0}) {
            const auto acts = law == TangentialLaw::none ? Friction::none : friction;
            BOOST_TEST_CONTEXT(name(law) << (pair ? ", pair" : "") << (acts == Friction::slip ? ", slip" : "")
                                         << (unloading ? ", unloading" : ""))
            BOOST_TEST(difference(pair, law, mode_of(acts, unloading, sign)) < 1e-6);
          }
}

BOOST_AUTO_TEST_CASE(other_contacts_are_clear_until_a_body_may_have_come_to_them) {
  auto bodies = scene(true, TangentialLaw::mindlin);
  bodies.contact.push_back({.a = {0, 0}, .b = {2, 0}, .law = contact::Hertz(1e9)});
  const auto setting = model::setting_of<2>(bodies, 1e-10);
  model::BodiesPhase<2> phase(setting, 0);
  const auto mode = mode_of(Friction::stick, false, 1);
  phase.bind(mode);
  const auto x = inside(bodies, setting, phase.layout());
  auto& balls = *phase.recorded()->balls();
  balls.begin(x, false);
  BOOST_TEST(balls.is_clear(x, 1e-4, 1));
  BOOST_TEST(!balls.is_clear(x, 1, 1));
}

BOOST_AUTO_TEST_CASE(fields_of_rods_and_of_several_contacts_are_not_compiled) {
  auto bodies = scene(false, TangentialLaw::mindlin);
  bodies.body[0].spheres = {{{0.001, 0, 0}, radius}};
  const auto setting = model::setting_of<2>(bodies, 1e-10);
  model::BodiesPhase<2> phase(setting, 0);
  const auto mode = mode_of(Friction::stick, false, 1);
  phase.bind(mode);
  BOOST_TEST(phase.recorded()->balls() == nullptr);
}
