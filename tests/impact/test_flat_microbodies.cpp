// Rods and dumbbells that land flat, on both tips at once.
#define BOOST_TEST_MODULE impact_flat_microbodies
#include <boost/test/unit_test.hpp>
#include <numbers>
#include <numeric>

#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

model::Microbody flat(const model::RigidBody& shape, double friction, double adhesion,
                      const Vector3& velocity) {
  const contact::Surface surface{.stiffness = 1.74e9, .adhesion = adhesion};
  model::Microbody body;
  body.body = shape;
  body.law.assign(2, contact::brach_dunn(surface, shape.tips[0].radius, 0, 0));
  body.friction = {friction};
  body.velocity = velocity;
  body.attitude = from_euler({0, std::numbers::pi / 2, 0});
  body.impacts = 2;
  return body;
}

Index steps(const impact::MicrobodyImpact& impact) {
  return std::accumulate(impact.flows.begin(), impact.flows.end(), Index{0},
                         [](Index sum, const auto& flow) { return sum + flow.steps; });
}

}  // namespace

// The cosine of π/2 is 6e-17, so that one tip closed 10⁻²¹ s after the other, and friction changed hands
// between them without end.
BOOST_AUTO_TEST_CASE(what_lands_flat_without_slip_holds_on_both_tips) {
  for (const auto& shape : {model::rod(2.45e-6, 10, density), model::dumbbell(2.45e-6, 10, density)})
    for (const double friction : {0.15, 0.7})
      for (const double adhesion : {0.0, 0.38}) {
        const auto body = flat(shape, friction, adhesion, {-5, 0, 0});
        const auto impact = impact::simulate(body, {.max_events = 40});
        BOOST_TEST((impact.ending == hybrid::Ending::separated));
        BOOST_TEST(norm(impact.final.velocity - Vector3{5, 0, 0}) < 1e-9);
        BOOST_TEST(reach(body) * norm(impact.final.spin) < 1e-9);
        BOOST_TEST(impact.events.size() < 8u);
        BOOST_TEST(steps(impact) < 3000);
      }
}

// Friction turns the slip of two tips that it holds near zero as fast as friction over the slip: Adams took
// a million steps.
BOOST_AUTO_TEST_CASE(two_tips_that_slip_in_space_take_thousands_of_steps) {
  for (const double friction : {0.15, 0.7}) {
    const auto body = flat(model::rod(2.45e-6, 10, density), friction, 0, {-5, 2, 1});
    const auto impact = impact::simulate(body);
    const auto stiff = impact::simulate(body, {.flow = flow::Kind::cvode_bdf_klu});
    BOOST_TEST(steps(impact) < 25000);
    BOOST_TEST(norm(impact.final.velocity - stiff.final.velocity) < 1e-8);
    BOOST_TEST(reach(body) * norm(impact.final.spin - stiff.final.spin) < 1e-8);
  }
}
