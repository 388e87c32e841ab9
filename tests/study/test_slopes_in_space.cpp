// Slopes of bodies in space without an axis of symmetry, where guards that are no events fire.
#define BOOST_TEST_MODULE slopes in space
#include <boost/test/unit_test.hpp>

#include "support/scene_slopes.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// Above a plane.
const std::string body = R"([bodies]
dimension = 3
law = "hertz"
stiffness = 1e8
[[bodies.body]]
shape = "custom"
mass = 0.1
spheres = [{ centre = [0.01, 0.005, 0], radius = 0.01 }]
inertia = [1.2e-5, 1.45e-5, 1.5e-5]
position = [0, 0, 0.03]
velocity = [0.3, 0, -2]
spin = [100, 200, 300]
[[bodies.plane]]
normal = [0, 0, 1]
)";

}  // namespace

// That bodies have strayed is asked at the same instants, and is no event. Expected is the difference of runs
// at 10⁻¹³.
BOOST_AUTO_TEST_CASE(events_fall_together_with_no_others) {
  const auto found = slopes_of(body + R"([[bodies.plane]]
normal = [1, 0, 0]
point = [-0.05, 0, 0]
[[bodies.body]]
mass = 0.1
radius = 0.01
position = [0, 0, 0.08]
velocity = [0, 0, -3]
[run]
until = 0.02
)",
                               {"body[0].velocity[2]"});
  for (const auto& note : found.notes)
    BOOST_TEST(note.text.find("fall together") == std::string::npos, note.text);
  BOOST_TEST(slope(found, "bodies[0].velocity[0]", 0) == 1.34342079086, boost::test_tools::tolerance(1e-8));
}

// The run ends when the body cannot come back, and its spin moves on.
BOOST_AUTO_TEST_CASE(what_moves_on_when_bodies_have_flown_apart_has_none) {
  const auto found = slopes_of(body, {"body[0].velocity[2]"});
  int velocities = 0, others = 0;
  for (const auto& one : found.outcome) {
    const bool is_velocity = one.name == "bodies[0].velocity", moves_on = one.name == "bodies[0].spin";
    velocities += is_velocity && one.slope[0].has_value();
    others += (moves_on || one.name == "time") && !one.slope[0].has_value();
  }
  BOOST_TEST(velocities == 3);
  BOOST_TEST(others == 4);
  BOOST_TEST_REQUIRE(!found.notes.empty());
  BOOST_TEST(found.notes[0].text.ends_with("nor has what still moves then"));
}
