// What slopes of a microbody are slopes of: the numbers of a run.
#define BOOST_TEST_MODULE impact microbody slopes
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// Its second tip strikes after the first has come off.
model::Microbody rod(double friction, Index impacts) {
  constexpr double radius = 2.45e-6;
  model::Microbody body;
  body.body = model::rod(radius, 10, density);
  body.law =
      std::vector(2, contact::brach_dunn({.stiffness = 1.74e9, .adhesion = 0.38}, radius, 7e-3, 8.7e-3));
  body.attitude = from_euler({0, 42 * std::numbers::pi / 180, 0});
  body.velocity = {-5, 0, 0};
  body.friction = {friction};
  body.impacts = impacts;
  return body;
}

impact::Sensitivity slopes(Index impacts) {
  return impact::sensitivity(
      rod(0.15, impacts),
      {{"friction", 0.15, 1e-4, [=](double value, auto& moved) { moved = rod(value, impacts); }}});
}

const impact::OutcomeSlopes& outcome(const impact::Sensitivity& slopes, const char* name) {
  return *std::ranges::find(slopes.outcome, name, &impact::OutcomeSlopes::name);
}

}  // namespace

// Central differences of runs at 1e-13 leave 1e-7 of the slope.
BOOST_AUTO_TEST_CASE(restitution_and_contact_time_are_those_of_the_first_impact) {
  constexpr double h = 1e-5;
  const auto run = [](double friction) { return impact::simulate(rod(friction, 2), {.accuracy = 1e-13}); };
  const auto low = run(0.15 - h), middle = run(0.15), high = run(0.15 + h);
  BOOST_TEST_REQUIRE(middle.impacts.size() == 2u);
  const auto told = slopes(2);
  const auto expect = [&](const char* name, auto&& number) {
    const double slope = (number(high) - number(low)) / (2 * h), value = number(middle);
    BOOST_TEST(std::abs(*outcome(told, name).value - value) < 1e-9 * std::abs(value), name);
    BOOST_TEST(std::abs(*outcome(told, name).slope[0] - slope) < 1e-6 * std::abs(slope), name);
  };
  expect("e_n", [](const auto& impact) { return impact.restitution.tip; });
  expect("e_nm", [](const auto& impact) { return impact.restitution.centre; });
  expect("contact_time", [](const auto& impact) { return *impact.impacts[0].end; });
  expect("normal_velocity", [](const auto& impact) { return impact.final.velocity.e1; });
}

BOOST_AUTO_TEST_CASE(a_second_impact_leaves_slopes_of_the_first_as_they_are) {
  for (const char* name : {"e_n", "e_nm", "contact_time"})
    BOOST_TEST(*outcome(slopes(2), name).slope[0] == *outcome(slopes(1), name).slope[0],
               boost::test_tools::tolerance(1e-9));
}
