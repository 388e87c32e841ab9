// A soft contact with friction whose path is prescribed by far stiffer springs: it loads and unloads in part
// and as a whole, and is sheared to and fro meanwhile. No such path may yield work.
#define BOOST_TEST_MODULE impact driven friction
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/impact/bodies/bodies_impact.hpp"

using namespace mariotte;
using model::TangentialLaw;

namespace {

constexpr Index floor_spring = 0, wall_spring = 1, soft = 2;

/// A ball that gravity presses into a corner of two springs without friction. The floor has another contact,
/// a hundredth as stiff, with friction. Dampers make the swings smaller: it opens again and again at first,
/// and later unloads in part.
model::Bodies corner(std::mt19937& random, TangentialLaw law) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const double ratio = uniform(0.5, 1);  // of tangential to normal stiffness
  model::Bodies bodies{.dimension = 2,
                       .gravity = {-uniform(5, 20), -uniform(5, 20), 0},
                       .body = {{.mass = 1,
                                 .inertia = {0, 0, uniform(0.4, 40)},
                                 .spheres = {{{}, 1}},
                                 .position = {1 + uniform(0, 0.01), 1 + uniform(0, 0.01), 0},
                                 .velocity = {uniform(-1, 1), uniform(-1, 0), 0},
                                 .spin = {0, 0, uniform(-1, 1)}}},
                       .plane = {{.normal = {0, 1, 0}}, {.normal = {1, 0, 0}}, {.normal = {0, 1, 0}}}};
  for (Index plane = 0; plane < 3; ++plane) bodies.contact.push_back({.a = {plane, -1}, .b = {0, 0}});
  for (const Index driver : {floor_spring, wall_spring})
    bodies.contact[driver].law =
        contact::Viscoelastic{.stiffness = uniform(100, 300), .damping = uniform(0.2, 2), .exponent = 1};
  bodies.contact[soft].law =
      law == TangentialLaw::mindlin ? contact::Law(contact::Hertz{1}) : contact::Law(contact::Linear{1});
  bodies.contact[soft].tangential = {law, uniform(0.05, 1), ratio};
  bodies.named = 3;
  return bodies;
}

const impact::BodyContactHistory& history(const impact::BodiesImpact& run, Index contact) {
  return *std::find_if(run.contacts.begin(), run.contacts.end(),
                       [&](const auto& one) { return one.contact == contact; });
}

/// How often a contact that has been unloaded in part is loaded again.
Index loads(const impact::BodiesImpact& run) {
  Index count = 0;
  for (const auto& event : run.events) count += std::ssize(event.of(model::BodyEvent::load));
  return count;
}

void check_paths(TangentialLaw law, unsigned seed) {
  std::mt19937 random(seed);
  constexpr double accuracy = 1e-9;
  Index loaded_again = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const auto run = impact::simulate(corner(random, law), {.accuracy = accuracy, .max_time = 4});
    const auto& friction = history(run, soft);
    loaded_again += loads(run);
    BOOST_TEST_CONTEXT("path " << trial << ": " << run.message) {
      BOOST_TEST((run.ending == hybrid::Ending::time_limit));
      BOOST_TEST(std::abs(run.energy.residual) <= 100 * accuracy * run.energy.initial);
      BOOST_TEST(friction.losses.friction + friction.losses.rescale > 0);
      BOOST_TEST(friction.losses.friction >= 0);
      BOOST_TEST(friction.losses.rescale >= 0);
      BOOST_TEST(friction.stored_in_friction >= 0);
    }
  }
  if (law == TangentialLaw::mindlin) BOOST_TEST(loaded_again > 100);
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_driven_path_of_a_mindlin_contact_yields_work) {
  check_paths(TangentialLaw::mindlin, 3);
}

BOOST_AUTO_TEST_CASE(no_driven_path_of_a_spring_yields_work) {
  check_paths(TangentialLaw::spring, 4);
}
