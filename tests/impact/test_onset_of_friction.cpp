// Contacts of strong dampers begin to stick, whatever rounding says of their depth.
#define BOOST_TEST_MODULE impact_onset_of_friction
#include <boost/test/unit_test.hpp>
#include <memory>

#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/stated_law.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "support/flow_steps.hpp"

using namespace mariotte;

namespace {

/// A body without an axis of symmetry, one ball beside its mass centre, that meets a plane three times.
model::Bodies tumbling_body(double damping) {
  const model::Body body{.name = "",
                         .mass = 0.1,
                         .inertia = {8e-6, 1.1e-5, 1.4e-5},
                         .spheres = {{{0.005, 0.003, -0.004}, 0.01}},
                         .position = {0, 0, 0.07},
                         .attitude = {},
                         .angle = 0,
                         .velocity = {-0.24, 0, -1},
                         .spin = {-18, -35, -7}};
  model::Bodies bodies{.dimension = 3};
  bodies.body = {body};
  bodies.plane = {{.name = "", .point = {}, .normal = {0, 0, 1}, .velocity = {}}};
  bodies.contact = {{.a = {0, -1},
                     .b = {0, 0},
                     .law = std::make_shared<contact::Tsuji>(3.6e9, damping),
                     .tangential = {model::TangentialLaw::spring, 0.3, 2.5e7}}};
  bodies.named = 1;
  return bodies;
}

}  // namespace

/// The force of the damper begins like δ^(1/4): where δ is rounding, the cap of friction may be none, and a
/// spring that yields there has a direction that turns without end.
BOOST_AUTO_TEST_CASE(a_stick_does_not_slip_where_its_depth_is_rounding) {
  for (const double damping : {52'743.99358443456, 4e4, 2e4})
    for (const double accuracy : {1e-9, 1e-10, 1e-11, 1e-12}) {
      const auto impact = impact::simulate(tumbling_body(damping), {.accuracy = accuracy, .max_time = 0.09});
      const auto steps = test::steps(impact);
      BOOST_TEST_MESSAGE(damping << " " << accuracy << ": " << steps << " steps");
      BOOST_TEST(steps < 20'000);
      double stuck = 0;
      for (const auto& event : impact.events) {
        if (!event.of(model::BodyEvent::stick).empty()) stuck = event.time;
        if (!event.of(model::BodyEvent::slip).empty()) BOOST_TEST(event.time - stuck > 1e-10);
      }
    }
}

/// Its damper pushes from the first instant on. What rounding of the depth makes of that is little; the whole
/// force would let the spring exceed its cap for as long as the contact lasts.
BOOST_AUTO_TEST_CASE(a_damped_adhesive_contact_slips_when_its_spring_exceeds_the_cap) {
  constexpr double radius = 5e-3;
  for (const double damping : {10.0, 100.0, 450.0})
    for (const double slip : {-0.2, -0.05, 0.1}) {
      model::Bodies bodies{.dimension = 2};
      bodies.body = {{.name = "",
                      .mass = 5.2e-4,
                      .inertia = {5.2e-9, 5.2e-9, 5.2e-9},
                      .spheres = {{{}, radius}},
                      .position = {0, 5.1e-3, 0},
                      .attitude = {},
                      .angle = 0,
                      .velocity = {slip, -0.12, 0},
                      .spin = {}}};
      bodies.plane = {{.name = "", .point = {}, .normal = {0, 1, 0}, .velocity = {}}};
      bodies.contact = {{.a = {0, -1},
                         .b = {0, 0},
                         .law = contact::state(contact::Jkr(5.5e6, radius, 0.02, damping)),
                         .tangential = {model::TangentialLaw::spring, 0.25, 450}}};
      bodies.named = 1;
      const auto run = [&](flow::Kind kind) {
        return impact::simulate(bodies, {.accuracy = 1e-10, .max_time = 0.01, .flow = kind});
      };
      const auto series = run(flow::Kind::taylor), adams = run(flow::Kind::cvode_adams);
      BOOST_TEST(series.events.size() == adams.events.size());
      BOOST_TEST(norm(series.body[0].velocity - adams.body[0].velocity) < 1e-10);
      BOOST_TEST(radius * norm(series.body[0].spin - adams.body[0].spin) < 1e-10);
    }
}
