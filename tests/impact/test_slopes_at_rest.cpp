// Slopes by motions along a rigid contact that has none: next to rest any slip rests at once. By hand.
#define BOOST_TEST_MODULE slopes next to rest
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/impact/sensitivity/sensitivity.hpp"

using namespace mariotte;
using model::Bodies;

namespace {

constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;

model::Body ball(const Vector3& position, const Vector3& velocity) {
  return {.name = "",
          .mass = mass,
          .inertia = {moment, moment, moment},
          .spheres = {{{}, radius}},
          .position = position,
          .velocity = velocity};
}

/// The first ball meets the second head on, from this gap; 0 touches.
Bodies pair(int dimension, double gap, double friction) {
  Bodies bodies{.dimension = dimension, .body = {ball({}, {1, 0, 0}), ball({2 * radius + gap, 0, 0}, {})}};
  bodies.contact = {{.a = {0, 0},
                     .b = {1, 0},
                     .law = contact::Hertz{1e9},
                     .tangential = {model::TangentialLaw::rigid, friction, 0},
                     .touching = gap == 0}};
  return bodies;
}

double slope(const Bodies& bodies, const std::string& outcome, const std::string& parameter) {
  std::vector<impact::Parameter<Bodies>> by;
  for (auto& one : impact::parameters(bodies))
    if (one.name == parameter) by.push_back(one);
  BOOST_TEST_REQUIRE(by.size() == 1u);
  for (const auto& one : impact::sensitivity(bodies, by).outcome)
    if (name_of(one) == outcome) return one.slope[0].value();
  throw std::runtime_error("no outcome " + outcome);
}

}  // namespace

// u = v₁ + r (ω₁ + ω₂) rests by the impulse m u/7: 2/m + 2 r²/I = 7/m.
BOOST_AUTO_TEST_CASE(a_slip_next_to_none_is_taken_away_by_friction) {
  for (const int dimension : {2, 3})
    for (const double gap : {0.0, 1e-3}) {
      const auto bodies = pair(dimension, gap, 0.3);
      const std::string spin = dimension == 2 ? "spin" : "spin[2]";
      BOOST_TEST_CONTEXT(dimension << " dimensions, gap " << gap) {
        const auto tight = boost::test_tools::tolerance(1e-9);
        BOOST_TEST(slope(bodies, "bodies[1]." + spin, "body[0]." + spin) == -2.5 / 7, tight);
        BOOST_TEST(slope(bodies, "bodies[0]." + spin, "body[0]." + spin) == 4.5 / 7, tight);
        if (gap == 0)
          BOOST_TEST(slope(bodies, "bodies[1]." + spin, "body[0].velocity[1]") == -2.5 / 7 / radius, tight);
      }
    }
}

// What has no friction keeps its slip.
BOOST_AUTO_TEST_CASE(a_slip_next_to_none_stays_without_friction) {
  for (const double gap : {0.0, 1e-3})
    BOOST_TEST(std::abs(slope(pair(2, gap, 0), "bodies[1].spin", "body[0].spin")) < 1e-12);
}
