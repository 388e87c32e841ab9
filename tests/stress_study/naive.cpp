// The naive simulators against closed forms.
#define BOOST_TEST_MODULE stress_study_naive
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "support/naive_bodies.hpp"
#include "support/naive_body.hpp"
#include "support/naive_chain.hpp"
#include "support/reference_laws.hpp"

using namespace mariotte;

namespace {

double naive_error(const model::Chain& chain, double end, const std::vector<double>& expected) {
  const auto run = test::run_naive(test::naive_contacts(chain), {.end = end, .speed = 1});
  BOOST_TEST_REQUIRE(run.complete);
  double most = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    most = std::max(most, std::abs(run.velocity[i] - expected[i]));
  return most;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_pair_exchanges_momentum_without_loss) {
  for (const contact::Law& law : {contact::Law(contact::Hertz{3}), contact::Law(contact::Linear{7})}) {
    const model::Chain chain{.mass = {1, 3}, .law = {law}, .gap = {0.5}, .velocity = {1, 0}};
    BOOST_TEST(naive_error(chain, 20, {-0.5, 0.5}) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(a_pair_that_flies_by_is_followed_to_the_accuracy_of_its_approach) {
  const double fast = 0x1p26;
  const model::Chain chain{
      .mass = {1, 3}, .law = {contact::Hertz{3}}, .gap = {0.5}, .velocity = {1 + fast, fast}};
  BOOST_TEST(naive_error(chain, 20, {-0.5 + fast, 0.5 + fast}) < 1e-7);
}

// A ball dropped from h onto a spring: down with v₀ = √(2gh), in contact for 2 (π − arctan(v₀ω/g))/ω, up
// again.
BOOST_AUTO_TEST_CASE(a_ball_bounces_on_a_wall_under_gravity) {
  const double g = 0.4, h = 0.3, k = 50, rate = std::sqrt(k), speed = std::sqrt(2 * g * h);
  const double touching = 2 / rate * (std::numbers::pi - std::atan(speed * rate / g));
  const model::Chain chain{
      .mass = {infinity, 1}, .law = {contact::Linear{k}}, .gap = {h}, .velocity = {0, 0}, .gravity = g};
  for (const double later : {0.2, 1.0, 1.9})
    BOOST_TEST(naive_error(chain, speed / g + touching + later * speed / g, {0, speed * (1 - later)}) < 1e-7);
}

// A ball lies still where k δ = m g.
BOOST_AUTO_TEST_CASE(a_ball_at_rest_on_a_wall_stays_there) {
  const model::Chain chain{.mass = {infinity, 1},
                           .law = {contact::Hertz{10}},
                           .gap = {-std::pow(0.1, 2.0 / 3.0)},
                           .velocity = {0, 0},
                           .gravity = 1,
                           .precompressed = true};
  BOOST_TEST(naive_error(chain, 100, {0, 0}) < 1e-7);
}

// Contacts that yield, adhere or have other dampers, until no force acts any more.
BOOST_AUTO_TEST_CASE(chains_of_other_laws_end_as_their_references) {
  for (const auto& c : test::law_cases("chains.json")) {
    BOOST_TEST_CONTEXT(c.at("contact").dump())
    BOOST_TEST(naive_error(test::chain_of(c), c.at("end_time"), test::sizes(c.at("velocity_after"))) < 5e-7);
  }
}

BOOST_AUTO_TEST_CASE(a_chain_and_the_same_as_a_network_move_alike) {
  const model::Chain chain{.mass = {1, 2, 0.5},
                           .law = {contact::Hertz{1}, contact::Viscoelastic{2, 0.3, 1.5}},
                           .gap = {0, 0.1},
                           .velocity = {1, 0, -0.5}};
  const auto run = test::run_naive(test::naive_contacts(model::as_network(chain)), {.end = 10, .speed = 1});
  BOOST_TEST_REQUIRE(run.complete);
  BOOST_TEST(naive_error(chain, 10, run.velocity) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_full_mass_matrix_is_solved) {
  const auto x = test::naive_solution({4, 1, 1, 3}, {1, 2});
  BOOST_TEST(std::abs(x[0] - 1.0 / 11) < 1e-15);
  BOOST_TEST(std::abs(x[1] - 7.0 / 11) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_sphere_without_damping_loses_nothing) {
  model::Microbody body;
  body.body = model::sphere(2.45e-6, 1350);
  body.law = {contact::brach_dunn({.stiffness = 1.74e9, .adhesion = 0.38}, 2.45e-6, 0, 0)};
  body.velocity = {-5, 0, 0};
  const test::NaiveBody field(body, 5, {});
  auto y = field.start();
  Index steps = 0;
  BOOST_TEST_REQUIRE(test::follow_naively(field, y, 1e-6, {}, steps));
  BOOST_TEST(std::abs(field.velocity(y).e1 - 5) < 5e-7);
}

/// A ball of mass 1 and radius 1 that strikes a plane at speed 1 downwards and 2 along it.
model::Bodies sliding_ball(model::TangentialLaw law) {
  model::Bodies bodies{.dimension = 2};
  bodies.body = {{.mass = 1,
                  .inertia = {0.4, 0.4, 0.4},
                  .spheres = {{{}, 1}},
                  .position = {0, 1, 0},
                  .velocity = {2, -1, 0}}};
  bodies.plane = {{.normal = {0, 1, 0}}};
  bodies.contact = {{.a = {0, -1},
                     .b = {0, 0},
                     .law = contact::Hertz{1e6},
                     .tangential = {law, 0.1, 1e6},
                     .share = 0,
                     .touching = true}};
  return bodies;
}

BOOST_AUTO_TEST_CASE(a_ball_that_slides_loses_what_friction_takes) {
  const auto bodies = sliding_ball(model::TangentialLaw::mindlin);
  test::NaiveBodies run(bodies, 2, {});
  BOOST_TEST_REQUIRE(run.follow(0.1, 100000));
  const auto& ball = run.bodies()[0];
  BOOST_TEST(std::abs(ball.velocity.e2 - 1) < 1e-4);
  BOOST_TEST(std::abs(ball.velocity.e1 - (2 - 0.1 * 2)) < 1e-3);
  BOOST_TEST(std::abs(ball.spin.e3 + 2.5 * 0.1 * 2) < 2e-3);
  BOOST_TEST(!test::NaiveBodies(bodies, 2, {}).follow(0.1, 5));
}

BOOST_AUTO_TEST_CASE(friction_without_a_spring_is_not_followed_naively) {
  BOOST_TEST(test::NaiveBodies::can_follow(sliding_ball(model::TangentialLaw::spring)));
  BOOST_TEST(!test::NaiveBodies::can_follow(sliding_ball(model::TangentialLaw::rigid)));
}

BOOST_AUTO_TEST_CASE(a_run_of_too_many_steps_is_not_complete) {
  const model::Chain chain{.mass = {1, 1}, .law = {contact::Hertz{1}}, .gap = {0}, .velocity = {1, 0}};
  const test::NaiveSettings settings{.end = 10, .speed = 1, .effort = {.most_steps = 5}};
  BOOST_TEST(!test::run_naive(test::naive_contacts(chain), settings).complete);
}
