// The series of a tip against CVODE, which follows the same field without any of their formulas.
#define BOOST_TEST_MODULE flow_tip_flows
#include <boost/test/unit_test.hpp>

#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

impact::MicrobodyImpact run(const model::Microbody& body, const std::string& flow, double accuracy) {
  return impact::simulate(body, {.accuracy = accuracy, .flow = flow::parse_kind(flow)});
}

double distance(const model::Microbody& body, const impact::MicrobodyImpact& a,
                const impact::MicrobodyImpact& b) {
  return std::max(norm(a.final.velocity - b.final.velocity),
                  reach(body) * norm(a.final.spin - b.final.spin)) /
         speed_scale(body);
}

/// Every `stride`-th case of a file by both.
void compare(const std::string& file, std::size_t stride, const std::string& flow, double tolerance) {
  const auto all = body_cases(file);
  for (std::size_t i = 0; i < all.size(); i += stride) {
    BOOST_TEST_CONTEXT(file << " case " << i) {
      const auto body = microbody(all[i]);
      const auto series = run(body, "auto", 1e-9), general = run(body, flow, 1e-9);
      BOOST_TEST(distance(body, series, general) < tolerance);
      BOOST_TEST(text(lasting(events_of(series))) == text(lasting(events_of(general))));
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(adams_agrees_with_the_series_of_normal_and_planar_motion) {
  compare("sphere_normal.json", 70, "cvode-adams", 1e-8);
  compare("rod_tilt.json", 270, "cvode-adams", 1e-8);
}

BOOST_AUTO_TEST_CASE(cvode_agrees_with_the_series_in_space) {
  compare("spatial.json", 1, "cvode-adams", 1e-8);
  compare("secondary.json", 2, "cvode-bdf-dense", 1e-8);
}

BOOST_AUTO_TEST_CASE(the_error_of_the_series_follows_the_accuracy) {
  for (const auto* file : {"sphere_oblique.json", "rod_events.json", "spatial.json"})
    for (const auto& c : body_cases(file)) {
      const auto body = microbody(c);
      const auto exact = run(body, "auto", 1e-13);
      for (const double accuracy : {1e-5, 1e-7, 1e-9, 1e-11})
        BOOST_TEST(distance(body, run(body, "auto", accuracy), exact) < 3 * accuracy);
    }
}

// A rod strikes slowly and sticks but for 10⁻¹⁷ s at each change of sign of the force, where slips of
// rounding size begin and end. A slip whose end is not seen is pushed on by friction.
BOOST_AUTO_TEST_CASE(friction_opposes_a_slip_that_has_hardly_begun) {
  constexpr double radius = 2.45e-6, speed = 0.077346874723314599;
  model::Microbody body;
  body.body = model::dumbbell(radius, 5.6321730004741548, density);
  body.law.assign(
      2, contact::brach_dunn(table_1, radius, 0,
                             contact::adhesion_damping(1.1830565151882628, table_1, radius, density, speed)));
  body.friction = {0.50014869828230024};
  body.velocity = {-speed, -0.16423237595514883, 0};
  const auto series = run(body, "auto", 1e-10);
  for (const auto* flow : {"cvode-adams", "cvode-bdf-dense", "cvode-bdf-klu"}) {
    const auto general = run(body, flow, 1e-10);
    BOOST_TEST(general.energy.friction > 0.3 * general.energy.initial);
    BOOST_TEST(distance(body, series, general) < 1e-8);
    BOOST_TEST(text(events_of(series)) == text(events_of(general)));
  }
}

BOOST_AUTO_TEST_CASE(only_the_states_that_move_are_followed) {
  const auto skips = [](const impact::MicrobodyImpact& impact, const std::string& what) {
    return std::any_of(impact.skipped.begin(), impact.skipped.end(),
                       [&](const impact::Skipped& one) { return one.what == what; });
  };
  const auto normal = run(microbody(body_cases("sphere_normal.json")[100]), "auto", 1e-9);
  BOOST_TEST(skips(normal, "tangential motion and rotation"));
  BOOST_TEST(skips(normal, "friction guards"));
  const auto planar = run(microbody(body_cases("rod_events.json")[3]), "auto", 1e-9);
  BOOST_TEST(skips(planar, "motion out of the plane"));
  const auto spatial = run(microbody(body_cases("spatial.json")[0]), "auto", 1e-9);
  BOOST_TEST(!skips(spatial, "motion out of the plane"));
}
