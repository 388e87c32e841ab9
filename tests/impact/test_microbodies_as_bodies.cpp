// A microbody as one of [bodies] with the same law: the same motion without friction, and a contact that
// gives way along the plane.
#define BOOST_TEST_MODULE microbodies as bodies
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/brach_dunn_law.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using model::TangentialLaw;

namespace {

constexpr double radius = 2.45e-6, damping_hertz = 0.03, damping_adhesion = 0.05;

model::Microbody microbody(const model::RigidBody& body, const Vector3& velocity) {
  model::Microbody micro;
  micro.body = body;
  micro.velocity = velocity;
  micro.law.assign(body.tips.size(),
                   contact::brach_dunn(test::table_1, radius, damping_hertz, damping_adhesion));
  return micro;
}

/// With its first tip alone, as the microbody has until its first impact is over.
model::Bodies as_bodies(const model::Microbody& micro, const model::Tangential& tangential) {
  model::Bodies bodies{.dimension = 3, .plane = {{.normal = {1, 0, 0}}}};
  bodies.body.push_back({.mass = micro.body.mass,
                         .inertia = micro.body.inertia,
                         .spheres = {{micro.body.tips[0].centre, radius}},
                         .position = {model::start_height(micro), 0, 0},
                         .attitude = micro.attitude,
                         .velocity = micro.velocity,
                         .spin = micro.spin});
  const auto law = contact::state(contact::BrachDunnLaw(
      0.75 * test::table_1.stiffness, radius, test::table_1.adhesion, damping_hertz, damping_adhesion));
  bodies.contact = {
      {.a = {0, -1}, .b = {0, 0}, .law = law, .tangential = tangential, .share = 0, .touching = true}};
  bodies.named = 1;
  return bodies;
}

/// Until a tip has long let go, a tenth of a microsecond or two.
impact::BodiesImpact strike(const model::Microbody& micro, const model::Tangential& tangential,
                            double accuracy) {
  return impact::simulate(as_bodies(micro, tangential), {.accuracy = accuracy, .max_time = 2e-7});
}

double loss(const impact::MicrobodyImpact& impact) {
  return impact.energy.hertz_damping + impact.energy.adhesion_damping;
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_friction_both_models_are_one) {
  auto rod = microbody(test::shape_of("rod", radius, 4), {-5, 0.7, -0.4});
  rod.attitude = from_euler({0.3, 0.6, 0.2});
  rod.spin = {2e5, -3e5, 1e5};
  for (const auto& micro : {microbody(test::shape_of("sphere", radius, 0), {-4, 1, 0}), rod})
    for (const double accuracy : {1e-6, 1e-10}) {
      const auto tip = impact::simulate(micro, {.accuracy = accuracy});
      const auto body = strike(micro, {}, accuracy);
      const double speed = norm(micro.velocity), time = tip.final.time;
      BOOST_TEST((tip.ending == hybrid::Ending::separated));
      BOOST_TEST(norm(body.body[0].velocity - tip.final.velocity) < 10 * accuracy * speed);
      BOOST_TEST(*body.contacts[0].periods[0].end == time, boost::test_tools::tolerance(10 * accuracy));
      BOOST_TEST(std::abs(body.contacts[0].losses.damper - loss(tip)) < 10 * accuracy * body.energy.initial);
    }
}

BOOST_AUTO_TEST_CASE(what_its_well_holds_stays) {
  const auto micro = microbody(test::shape_of("sphere", radius, 0), {-0.8, 0, 0});
  BOOST_TEST((impact::simulate(micro, {}).ending == hybrid::Ending::captured));
  const auto body = impact::simulate(as_bodies(micro, {}), {.accuracy = 1e-6, .max_time = 1e-6});
  BOOST_TEST(!body.contacts[0].periods.back().end.has_value());
  const double rest = contact::rest_indentation(micro.law[0]);
  BOOST_TEST(radius - body.body[0].position.e1 == rest, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(body.contacts[0].stored < 0);
}

// A contact that gives way along the plane throws the tip back; a very stiff one is a rigid stick.
BOOST_AUTO_TEST_CASE(a_microbody_may_give_way_along_the_plane) {
  const auto micro = microbody(test::shape_of("sphere", radius, 0), {-4, 0.8, 0});
  const auto slip = [&](const model::Tangential& tangential) {
    const auto body = strike(micro, tangential, 1e-9);
    BOOST_TEST(std::abs(body.energy.residual) < 1e-7 * body.energy.initial);
    for (const auto each : impact::each_loss) BOOST_TEST((body.energy.losses.*each >= 0));
    return body.body[0].velocity.e2 - radius * body.body[0].spin.e3;
  };
  const double rigid = slip({TangentialLaw::rigid, 0.5, 0});
  BOOST_TEST(std::abs(rigid) < 1e-9);
  BOOST_TEST(slip({TangentialLaw::spring, 0.5, 400}) < -0.1);
  double last = 1;
  for (const double stiffness : {1e4, 1e5, 1e6}) {
    const double apart = std::abs(slip({TangentialLaw::spring, 0.5, stiffness}) - rigid);
    BOOST_TEST(apart < 0.3 * last);
    last = apart;
  }
}
