// Bodies that fly much faster than they move among themselves.
#define BOOST_TEST_MODULE impact_bodies_frame
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/bodies/bodies_frame.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "support/struck_balls.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// So fast that half of the digits of a velocity are the common one's.
const Vector3 swift{0x1p26, -0x1p25, 0};

model::Bodies flying(model::Bodies bodies) {
  for (auto& body : bodies.body) body.velocity = body.velocity + swift;
  return bodies;
}

model::Bodies in_space() {
  auto bodies = meeting(mindlin);
  bodies.dimension = 3;
  bodies.body[0].velocity.e3 = 0.0625;
  bodies.body[1].spin.e1 = 16;
  return bodies;
}

/// Seen by the first one, with so many digits that none is lost beside the common velocity.
model::Bodies resting(model::Bodies bodies) {
  const auto first = bodies.body[0].velocity;
  for (auto& body : bodies.body) {
    const auto seen = body.velocity - first + swift;
    body.velocity = seen - swift;
  }
  return bodies;
}

const double lost = 2 * epsilon * norm(swift);

void check_near(const Vector3& value, const Vector3& expected, double tolerance) {
  test::check_near(norm(value - expected), 0, tolerance);
}

}  // namespace

BOOST_AUTO_TEST_CASE(bodies_that_fly_do_what_they_do_at_rest) {
  for (const auto& bodies : {resting(meeting(mindlin)), resting(meeting(rigid)), resting(in_space())}) {
    const auto still = impact::simulate(bodies), fast = impact::simulate(flying(bodies));
    BOOST_TEST((fast.ending == hybrid::Ending::separated));
    BOOST_TEST(fast.events.size() == still.events.size());
    BOOST_TEST(fast.time == still.time);
    for (std::size_t i = 0; i < bodies.body.size(); ++i) {
      check_near(fast.body[i].velocity, still.body[i].velocity + swift, lost);
      check_near(fast.body[i].position, still.body[i].position + still.time * swift, still.time * lost);
      BOOST_TEST(norm(fast.body[i].spin - still.body[i].spin) == 0);
    }
    BOOST_TEST(fast.contacts[0].normal_impulse == still.contacts[0].normal_impulse);
    BOOST_TEST(fast.energy.losses.total() == still.energy.losses.total());
    BOOST_TEST(fast.energy.residual == still.energy.residual);
  }
}

BOOST_AUTO_TEST_CASE(energies_are_those_of_outside) {
  const auto bodies = flying(resting(meeting(mindlin)));
  const auto fast = impact::simulate(bodies);
  const auto kinetic = [&](const auto& velocity_of, const auto& spin_of) {
    double sum = 0;
    for (std::size_t i = 0; i < bodies.body.size(); ++i) {
      const auto v = velocity_of(i), spin = spin_of(i);
      sum += 0.5 * mass * dot(v, v) + 0.5 * bodies.body[i].inertia.e3 * dot(spin, spin);
    }
    return sum;
  };
  const double before = kinetic([&](std::size_t i) { return bodies.body[i].velocity; },
                                [&](std::size_t i) { return bodies.body[i].spin; }),
               after = kinetic([&](std::size_t i) { return fast.body[i].velocity; },
                               [&](std::size_t i) { return fast.body[i].spin; });
  BOOST_TEST(std::abs(fast.energy.initial - before) <= 8 * epsilon * before);
  BOOST_TEST(std::abs(fast.energy.final - after) <= 8 * epsilon * after);
}

BOOST_AUTO_TEST_CASE(who_looks_on_is_told_velocities_from_outside) {
  double least = infinity;
  impact::Sampling sampling{.velocities = {0, 2}, .take = [&](const impact::Sample& sample) {
                              for (const double v : sample.velocity) least = std::min(least, v);
                              return sample.natural_time;
                            }};
  const auto traced = impact::simulate(flying(meeting(spring)), {}, {.trace = true, .samplings = {sampling}});
  BOOST_TEST(least > swift.e1 - 2);
  for (std::size_t k = 0; k < traced.trace.time.size(); ++k)
    for (const auto& body : traced.trace.body[k]) {
      check_near(body.velocity, swift, 2);
      check_near(body.position, traced.trace.time[k] * swift, 0.1);
    }
}

BOOST_AUTO_TEST_CASE(slopes_are_those_of_bodies_at_rest) {
  const auto slow = resting(meeting(mindlin)), moving = flying(slow);
  const auto still = sensitivity(slow, impact::parameters(slow)),
             fast = sensitivity(moving, impact::parameters(moving));
  BOOST_TEST(fast.outcome.size() == still.outcome.size());
  for (std::size_t i = 0; i < still.outcome.size(); ++i) {
    const auto &one = still.outcome[i], &other = fast.outcome[i];
    const bool flies = one.name.ends_with("velocity");
    const double common = !flies ? 0 : *one.index == 0 ? swift.e1 : swift.e2;
    test::check_near(*other.value, *one.value + common, flies ? lost : 0);
    for (std::size_t c = 0; c < one.slope.size(); ++c)
      test::check_near(*other.slope[c], *one.slope[c], 1e-6 * (1 + std::abs(*one.slope[c])));
  }
}

BOOST_AUTO_TEST_CASE(a_frame_is_left_only_where_nothing_tells_it_from_another) {
  const auto bodies = flying(meeting(mindlin));
  BOOST_TEST(impact::moving_frame(bodies).at(3) == bodies.body[0].velocity.e2);
  auto falling = bodies, walled = bodies, wide = bodies;
  falling.gravity.e2 = -1;
  walled.plane = strike(0, rigid).plane;
  wide.body[1].velocity = {};
  for (const auto& other : {falling, walled, wide, meeting(mindlin)})
    BOOST_TEST(!impact::moving_frame(other));
}
