// Impact laws beside the first compliant impact of bodies.
#define BOOST_TEST_MODULE first impact
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/first_impact.hpp"

using namespace mariotte;
using model::TangentialLaw;

namespace {

constexpr double mass = 0.1, half_length = 0.05;

/// A rod whose ends are points, one of which strikes the plane y = 0.
model::Bodies rod(double angle, const model::Tangential& tangential, const contact::Law& law) {
  model::Bodies bodies{.dimension = 2};
  bodies.body = {{.name = "rod",
                  .mass = mass,
                  .inertia = {1, 1, mass * half_length * half_length / 3},
                  .spheres = {{{-half_length, 0, 0}, 0}, {{half_length, 0, 0}, 0}},
                  .position = {0, 0.1, 0},
                  .angle = angle,
                  .velocity = {1, -1, 0}}};
  bodies.plane = {{.name = "floor", .point = {}, .normal = {0, 1, 0}, .velocity = {}}};
  for (const Index sphere : {0, 1})
    bodies.contact.push_back({.a = {0, -1}, .b = {0, sphere}, .law = law, .tangential = tangential});
  return bodies;
}

const impact::FrictionOutcome& outcome(const impact::FirstImpact& impact, const std::string& law) {
  for (const auto& one : impact.outcomes)
    if (one.law == law) return one;
  throw std::out_of_range(law);
}

double apart(const impact::InContact& a, const impact::InContact& b) {
  return std::hypot(a.normal - b.normal, a.tangential - b.tangential);
}

constexpr double steep = std::numbers::pi / 4;
constexpr model::Tangential rigid{TangentialLaw::rigid, 0.3, 0};

}  // namespace

// W of a thin rod at 45° whose lower end is at (−1, −1) l/√2: (1 + 3/2)/m and (3/2)/m.
BOOST_AUTO_TEST_CASE(the_contact_is_that_of_the_rod_as_it_meets_the_plane) {
  const auto impact = impact::first_impact(rod(steep, rigid, contact::Hertz(1e9)), {});
  const auto& c = impact.contact;
  BOOST_TEST(impact.between[1] == "rod.1");
  BOOST_TEST(impact.start == 0.1 - half_length * std::sqrt(0.5), boost::test_tools::tolerance(1e-12));
  for (const auto& [value, expected] : {std::pair{c.nn, 2.5}, {c.tt, 2.5}, {c.nt, 1.5}})
    BOOST_TEST(value * mass == expected, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(c.velocity.normal + 1) < 1e-12);
  BOOST_TEST(std::abs(std::abs(c.velocity.tangential) - 1) < 1e-12);
  BOOST_TEST(impact.energy == mass, boost::test_tools::tolerance(1e-12));
}

// With rigid friction and a normal force that keeps its work, e = 1 in Stronge's sense, and his law is the
// limit of stiff contacts; slip ends and turns round meanwhile.
BOOST_AUTO_TEST_CASE(stiff_contacts_tend_to_stronges_law) {
  double last = 1;
  for (const double stiffness : {1e8, 1e11, 1e14}) {
    const auto impact = impact::first_impact(rod(steep, rigid, contact::Hertz(stiffness)), {});
    const auto &truth = outcome(impact, "simulation"), &law = outcome(impact, "stronge");
    BOOST_TEST(std::abs(*law.restitution - 1) < 1e-9);
    const double error = apart(truth.velocity, law.velocity);
    BOOST_TEST(error < 0.2 * last);
    last = error;
    BOOST_TEST(std::abs(truth.loss - law.loss) < 2 * mass * error);
    BOOST_TEST(norm(truth.body[0].velocity - law.body[0].velocity) < error);
    BOOST_TEST(half_length * std::abs(truth.body[0].spin - law.body[0].spin) < 3 * error);
  }
  BOOST_TEST(last < 1e-4);
}

// Each law is told its own coefficient, so the normal velocity is Newton's and the normal impulse Poisson's.
BOOST_AUTO_TEST_CASE(laws_are_told_their_own_restitution) {
  const contact::Law damped = contact::Viscoelastic{.stiffness = 1e9, .damping = 3e4, .exponent = 1.5};
  const auto impact = impact::first_impact(rod(steep, rigid, damped), {});
  const auto& truth = outcome(impact, "simulation");
  const auto &newton = outcome(impact, "newton"), &poisson = outcome(impact, "poisson");
  BOOST_TEST(std::abs(newton.velocity.normal - truth.velocity.normal) < 1e-9);
  BOOST_TEST(std::abs(poisson.impulse.normal - truth.impulse.normal) < 1e-3 * truth.impulse.normal);
  BOOST_TEST(*outcome(impact, "stronge").restitution < 0.95);
  for (const auto& one : impact::first_impact(rod(steep, rigid, damped), {}, 0.5).outcomes)
    BOOST_TEST((one.law == "simulation" ? !one.restitution : *one.restitution == 0.5));
}

BOOST_AUTO_TEST_CASE(springs_of_friction_are_no_work_of_the_normal_force) {
  const auto impact =
      impact::first_impact(rod(steep, {TangentialLaw::mindlin, 0.3, 1.2e9}, contact::Hertz(1e9)), {});
  BOOST_TEST(std::abs(*outcome(impact, "stronge").restitution - 1) < 1e-9);
  for (const auto& one : impact.outcomes)
    BOOST_TEST(one.energy == impact.energy - one.loss, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(two_balls_exchange_what_the_laws_say) {
  model::Bodies bodies{.dimension = 2};
  const double moment = 0.4 * mass * 1e-4;
  for (const double x : {0.0, 0.02})
    bodies.body.push_back(
        {.mass = mass, .inertia = {1, 1, moment}, .spheres = {{{}, 0.01}}, .position = {x, 0, 0}});
  bodies.body[0].velocity = {1, 0.2, 0};
  bodies.contact = {
      {.a = {0, 0}, .b = {1, 0}, .law = contact::Hertz(1e12), .tangential = rigid, .touching = true}};
  const auto impact = impact::first_impact(bodies, {});
  const auto& law = outcome(impact, "poisson");
  BOOST_TEST(impact.start == 0);
  BOOST_TEST(law.velocity.tangential == 0);
  BOOST_TEST(norm(law.body[1].velocity - Vector3{1, 0.2 / 7, 0}) < 1e-6);
  BOOST_TEST(norm(law.body[0].velocity + law.body[1].velocity - Vector3{1, 0.2, 0}) < 1e-14);
  BOOST_TEST(norm(outcome(impact, "simulation").body[1].velocity - law.body[1].velocity) < 1e-3);
  for (const int i : {0, 1})
    BOOST_TEST(law.body[i].spin == -0.2 / 7 * mass * 0.01 / moment, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_belt_gives_energy_that_the_contact_does_not_lose) {
  auto bodies = rod(steep, rigid, contact::Hertz(1e9));
  bodies.plane[0].velocity = {9, 0, 0};
  const auto impact = impact::first_impact(bodies, {});
  for (const auto& one : impact.outcomes) {
    BOOST_TEST(one.loss > 0, one.law);
    BOOST_TEST(one.energy > impact.energy, one.law);
  }
}

BOOST_AUTO_TEST_CASE(impacts_that_are_not_of_one_contact_are_refused) {
  const auto refused = [](const model::Bodies& bodies, const hybrid::Options& options = {}) {
    BOOST_CHECK_THROW(impact::first_impact(bodies, options), InvalidParameter);
  };
  const contact::Law law = contact::Hertz(1e9);
  refused(rod(0, rigid, law));  // both ends at once
  auto away = rod(steep, rigid, law);
  away.body[0].velocity = {1, 1, 0};
  refused(away);
  refused(rod(steep, rigid, law), {.max_time = 0.0647});  // still closed
  auto space = rod(steep, rigid, law);
  space.dimension = 3;
  refused(space);
}
