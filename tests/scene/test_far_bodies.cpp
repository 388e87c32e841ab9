// Scenes of bodies with scales far apart: rods that are long beside their indentations, and contacts that are
// over at once.
#include <fmt/format.h>

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <ostream>
#include <string>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/scene/scene.hpp"

using namespace mariotte;

namespace {

struct FarCase {
  std::string name;
  double along, away, spin;  ///< velocity and spin at the end
  double reach, speed;       ///< largest of the body
};
std::ostream& operator<<(std::ostream& out, const FarCase& one) {
  return out << one.name;
}

/// Rods: by another integrator, of order 8 in extended precision. Quick contacts: on which Adams and the same
/// scene at a speed of 1 m/s agree.
const FarCase cases[] = {
    {"far_end", 0.00360185247811, -0.00219827996826, -4.384592895178, 0.0014, 0.006},
    {"gripping_spring", 0.006547487011610265, -0.02640352689767776, -3880.3540899572686, 5.4e-6, 0.03},
    {"quick_adhesion", 2142471.0880, 9992296.5602, -2142584943701.3, 1e-6, 1e7},
    {"quick_yield", 21424319.1289, 70710678.1184, -21431896835584.4, 1e-6, 1e8}};

}  // namespace

BOOST_DATA_TEST_CASE(bodies_of_scales_far_apart_keep_their_accuracy, boost::unit_test::data::make(cases),
                     one) {
  const auto scene = scene::read(fmt::format("{}/bodies/hard/{}.toml", MARIOTTE_TEST_DATA, one.name));
  const auto impact = impact::simulate(std::get<model::Bodies>(scene.model), scene.run);
  BOOST_TEST((impact.ending == hybrid::Ending::time_limit), impact.message);
  const double allowed = scene.run.accuracy * one.speed;
  const auto& end = impact.body[0];
  BOOST_TEST(std::abs(end.velocity.e1 - one.along) < allowed);
  BOOST_TEST(std::abs(end.velocity.e2 - one.away) < allowed);
  BOOST_TEST(one.reach * std::abs(end.spin.e3 - one.spin) < allowed);
}

// A spring that was beyond its cap by CVODE's error held on, and its guard fired again at once, without end.
BOOST_AUTO_TEST_CASE(a_spring_beyond_its_cap_is_put_back_to_it) {
  const auto scene = scene::read(MARIOTTE_TEST_DATA "/bodies/hard/rattling_dumbbell.toml");
  auto options = scene.run;
  options.accuracy = 1e-12;
  const auto by_series = impact::simulate(std::get<model::Bodies>(scene.model), options);
  options.flow = flow::Kind::cvode_adams;
  const auto by_adams = impact::simulate(std::get<model::Bodies>(scene.model), options);
  BOOST_TEST((by_adams.ending == hybrid::Ending::time_limit), by_adams.message);
  const double speed = norm(by_series.body[0].velocity);
  BOOST_TEST(norm(by_adams.body[0].velocity - by_series.body[0].velocity) < 1e-9 * speed);
}
