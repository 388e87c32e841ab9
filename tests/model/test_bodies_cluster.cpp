// Compiled series of several contacts of balls beside the field of any bodies: two ways to one motion.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/flow/cluster/cluster_series.hpp"
#include "mariotte/flow/cluster/cluster_taylor.hpp"
#include "mariotte/model/bodies/bodies_phase.hpp"
#include "support/random_balls.hpp"

using namespace mariotte;
using namespace mariotte::test;
using flow::ClusterClock;
using flow::ClusterField;
using model::Friction;
using model::TangentialLaw;

namespace {

struct Kind {
  bool linear;
  TangentialLaw law;
  Friction friction;
  bool unloading;
  double sign;
};

/// Three balls in a triangle, two of them on a plane that moves, and one that may meet the third. At the
/// depth 0 all meet.
model::Bodies scene(const std::vector<Kind>& kinds, double depth) {
  model::Bodies bodies{.dimension = 2, .gravity = {in(-300, 300), in(-300, 300), 0}};
  const double apart = 2 * radius - depth;
  bodies.body = {ball({0, radius - depth, 0}), ball({apart, radius - depth, 0}),
                 ball({0.5 * apart, radius - depth + std::sqrt(0.75) * apart, 0}),
                 ball({0.5 * apart, 4.8 * radius, 0})};
  for (auto& body : bodies.body)
    if (depth == 0)
      body.velocity = (-1 / radius) * (body.position - Vector3{0.5 * apart, in(1.5, 1.7) * radius, 0}) +
                      Vector3{0, -1, 0};
  bodies.plane = {{.name = "", .point = {}, .normal = {0, 1, 0}, .velocity = {0.3, 0.1, 0}}};
  const std::pair<model::Feature, Index> pairs[] = {
      {{0, -1}, 0}, {{0, -1}, 1}, {{0, 0}, 1}, {{0, 0}, 2}, {{1, 0}, 2}};
  for (std::size_t i = 0; i < std::size(pairs); ++i) {
    const auto& kind = kinds[i % kinds.size()];
    const double stiffness = kind.law == TangentialLaw::spring ? 0.8e6 : 0.8e9;
    bodies.contact.push_back(
        {.a = pairs[i].first,
         .b = {pairs[i].second, 0},
         .law = kind.linear ? contact::Law(contact::Linear(1e6)) : contact::Law(contact::Hertz(1e9)),
         .tangential = {kind.law, 0.3, stiffness},
         .share = in(0, 1)});
  }
  bodies.contact.push_back({.a = {2, 0}, .b = {3, 0}, .law = contact::Hertz(1e9)});
  return bodies;
}

model::BodiesMode mode_of(const std::vector<Kind>& kinds) {
  model::BodiesMode mode;
  for (Index i = 0; i < 5; ++i) {
    const auto& kind = kinds[i % kinds.size()];
    mode.closed.push_back({.contact = i,
                           .slot = i,
                           .friction = kind.law == TangentialLaw::none ? Friction::none : kind.friction,
                           .unloading = kind.unloading,
                           .sign = kind.sign,
                           .start = {}});
  }
  mode.totals.resize(6);
  return mode;
}

/// Springs are stretched.
std::vector<double> stretched(const model::Bodies& bodies, const model::BodiesSetting<2>& setting,
                              const model::BodiesLayout<2>& at, const std::vector<Kind>& kinds) {
  auto x = initial_state(bodies, setting);
  x.resize(at.size(), 0.0);
  for (Index i = 0; i < 5; ++i) {
    const auto& kind = kinds[i % kinds.size()];
    const bool as_force = kind.law == TangentialLaw::mindlin && !kind.unloading;
    if (kind.friction == Friction::stick) x[at.spring(i)] = as_force ? in(-10, 10) : in(-1e-6, 1e-6);
  }
  return x;
}

/// Largest difference, over the size of each component, of the slope of the series after a time and the rates
/// there.
double difference(const std::vector<Kind>& kinds, const ClusterClock& clock) {
  const bool begins = clock.kind == ClusterClock::Kind::onset;
  const auto bodies = scene(kinds, begins ? 0 : 5e-5);
  const auto setting = model::setting_of<2>(bodies, 1e-10);
  model::BodiesPhase<2> phase(setting, 0);
  const auto mode = mode_of(kinds);
  phase.bind(mode);
  auto& phase_cluster = *phase.recorded()->cluster();
  const auto start = stretched(bodies, setting, phase.layout(), kinds);
  phase_cluster.gather(start, true);
  const auto& cluster = phase_cluster.load(start, begins);
  flow::ClusterSeries series;
  series.expand(cluster, clock, 18);
  const double time_scale = 0.05 * phase.time_scale();
  const double place = begins ? std::sqrt(time_scale) : time_scale / series.clock()[0], small = 1e-4 * place;
  flow::ClusterMotion motion;
  const auto moved = [&](double to) {
    std::vector<double> x(start.size());
    series.move(to, motion);
    phase_cluster.move(start, motion, x);
    return x;
  };
  const auto low = moved(place - small), middle = moved(place), high = moved(place + small);
  std::vector<double> rates(start.size());
  phase.derivative(middle, rates);
  const double time = high[phase.layout().clock()] - low[phase.layout().clock()];
  double most = 0;
  for (std::size_t i = 0; i < rates.size(); ++i)
    most = std::max(
        most, std::abs((high[i] - low[i]) / time - rates[i]) * phase.time_scale() / phase.magnitudes()[i]);
  return most;
}

std::vector<Kind> every_kind() {
  std::vector<Kind> kinds = {{false, TangentialLaw::none, Friction::none, false, 1},
                             {true, TangentialLaw::none, Friction::none, true, 1}};
  for (const auto friction : {Friction::stick, Friction::slip})
    for (const bool unloading : {false, true}) {
      kinds.push_back({false, TangentialLaw::mindlin, friction, unloading, unloading ? 1.0 : -1.0});
      kinds.push_back({false, TangentialLaw::spring, friction, unloading, 1});
      kinds.push_back({true, TangentialLaw::spring, friction, unloading, -1});
    }
  kinds.push_back({false, TangentialLaw::rigid, Friction::slip, false, 1});
  return kinds;
}

}  // namespace

BOOST_AUTO_TEST_CASE(series_of_clusters_are_those_of_any_bodies) {
  for (const auto& kind : every_kind())
    for (const auto clock : {ClusterClock::Kind::time, ClusterClock::Kind::root}) {
      if (kind.linear && clock == ClusterClock::Kind::root) continue;
      BOOST_TEST_CONTEXT(name(kind.law) << (kind.linear ? ", linear" : "")
                                        << (kind.friction == Friction::slip ? ", slip" : "")
                                        << (kind.unloading ? ", unloading" : ""))
      BOOST_TEST(difference({kind}, {clock, 2}) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(contacts_of_different_kinds_stand_side_by_side) {
  const auto kinds = every_kind();
  const Kind third = {false, TangentialLaw::mindlin, Friction::stick, true, 1};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    BOOST_TEST(difference({kinds[i], kinds[(i + 3) % kinds.size()], third}, {ClusterClock::Kind::root, 2}) <
               1e-6);
}

BOOST_AUTO_TEST_CASE(contacts_begin_together) {
  for (const auto& kind : every_kind())
    if (!kind.unloading) BOOST_TEST(difference({kind}, {ClusterClock::Kind::onset}) < 1e-6);
}

BOOST_AUTO_TEST_CASE(rigid_sticks_and_rods_are_no_clusters) {
  const Kind rigid = {false, TangentialLaw::rigid, Friction::stick, false, 1};
  auto bodies = scene({rigid}, 5e-5);
  const auto is_cluster = [&](const Kind& kind) {
    const auto setting = model::setting_of<2>(bodies, 1e-10);
    model::BodiesPhase<2> phase(setting, 0);
    const auto mode = mode_of({kind});
    phase.bind(mode);
    return phase.recorded()->cluster() != nullptr;
  };
  BOOST_TEST(!is_cluster(rigid));
  BOOST_TEST(is_cluster({false, TangentialLaw::rigid, Friction::slip, false, 1}));
  bodies.body[3].spheres = {{{0.001, 0, 0}, radius}};
  BOOST_TEST(!is_cluster({false, TangentialLaw::rigid, Friction::slip, false, 1}));
}

BOOST_AUTO_TEST_CASE(near_contacts_are_listed_anew_before_a_ball_leaves_its_place) {
  const Kind kind = {false, TangentialLaw::mindlin, Friction::stick, false, 1};
  const auto bodies = scene({kind}, 5e-5);
  auto setting = model::setting_of<2>(bodies, 1e-10);
  setting.skin = 1e-3;
  model::BodiesPhase<2> phase(setting, 0);
  auto mode = mode_of({kind});
  mode.near = {0, 1, 2, 3, 4, 5};
  mode.from.assign(8, 0.0);
  phase.bind(mode);
  auto& cluster = *phase.recorded()->cluster();
  auto x = stretched(bodies, setting, phase.layout(), {kind});
  cluster.gather(x, true);
  const std::vector<double> little(4, 1e-5), much(4, 6e-4);
  BOOST_TEST(cluster.stays_far(x, 1e-6, little));
  BOOST_TEST(!cluster.stays_far(x, 1e-6, much));
  BOOST_TEST(cluster.stray(x) == -1);
  x[phase.layout().shift(1)] += 3e-4;
  BOOST_TEST(cluster.stray(x) == phase.stray_guard(1));
}

/// A spring of constant stiffness exceeds a cap that begins with δ^{3/2}, were its slip not zero.
BOOST_AUTO_TEST_CASE(a_slip_that_is_rounding_does_not_end_a_stick) {
  const Kind kind = {false, TangentialLaw::spring, Friction::stick, false, 1};
  auto bodies = scene({kind}, 0);
  bodies.gravity = {};
  bodies.contact = {bodies.contact[2], bodies.contact[5]};
  for (auto& body : bodies.body) body.velocity = body.spin = {};
  bodies.body[1].velocity = {-1e-10, 1e-19, 0};
  bodies.body[3].velocity = {0, 1, 0};
  const auto setting = model::setting_of<2>(bodies, 1e-9);
  model::BodiesPhase<2> phase(setting, 0);
  auto mode = mode_of({kind});
  mode.closed.resize(1);
  phase.bind(mode);
  auto x = initial_state(bodies, setting);
  x.resize(phase.layout().size(), 0.0);
  std::vector<Index> fired;
  flow::ClusterTaylor taylor;
  const auto arrival = taylor.follow(phase, *phase.recorded()->cluster(), x,
                                     {.limit = phase.time_scale(), .accuracy = 1e-9}, fired, {});
  BOOST_CHECK(arrival.outcome == flow::Outcome::limit);
  BOOST_TEST(fired.empty());
}
