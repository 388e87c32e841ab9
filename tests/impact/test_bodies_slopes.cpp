// Slopes of bodies that touch each other with friction: beside differences of tight runs, by hand, and where
// they are refused.
#define BOOST_TEST_MODULE slopes of bodies with friction
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"

using namespace mariotte;
using impact::Sensitivity;
using model::Bodies;
using model::Tangential;
using model::TangentialLaw;

namespace {

constexpr Tangential rigid{TangentialLaw::rigid, 0.2, 0}, spring{TangentialLaw::spring, 0.3, 4e5},
    mindlin{TangentialLaw::mindlin, 0.25, 0.8e9};

/// Two bodies, the first a ball or a rod, that meet off centre, and a plane that moves towards the second.
class Scenes {
 public:
  explicit Scenes(unsigned seed) : random_(seed) {}

  Bodies next(int dimension, const contact::Law& law, const Tangential& tangential) {
    Bodies bodies{.dimension = dimension, .gravity = {0.5, in(-30, 0), 0}};
    for (int i = 0; i < 2; ++i) bodies.body.push_back(body(i, dimension));
    if (in(0, 1) < 0.5)
      bodies.plane.push_back(
          {.name = "", .point = {0, -0.02, 0}, .normal = {0, 1, 0}, .velocity = {0, 0.3, 0}});
    for (Index k = 0; k < std::ssize(bodies.body[0].spheres); ++k) {
      bodies.contact.push_back({.a = {0, k}, .b = {1, 0}, .law = law, .tangential = tangential});
      if (!bodies.plane.empty())
        bodies.contact.push_back({.a = {0, -1}, .b = {0, k}, .law = law, .tangential = tangential});
    }
    return bodies;
  }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

 private:
  double in(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  Vector3 vector(double size, int dimension) {
    return {in(-size, size), in(-size, size), dimension == 3 ? in(-size, size) : 0};
  }
  model::Body body(int i, int dimension) {
    constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;
    const bool is_rod = i == 0 && in(0, 1) < 0.5;
    model::Body one{.name = "", .mass = mass * in(0.5, 1.5), .inertia = {moment, moment, moment}};
    if (is_rod) one.inertia = {moment, 3 * moment, 3 * moment};
    one.spheres = {{{is_rod ? 0.008 : 0.0, 0, 0}, radius}};
    if (is_rod) one.spheres.push_back({{-0.008, 0, 0}, radius});
    one.position = {0.045 * i, in(-0.004, 0.004), 0};
    one.velocity = vector(0.3, dimension) + Vector3{1.0 - 2 * i, 0, 0};
    one.spin = dimension == 3 ? vector(60, 3) : Vector3{0, 0, in(-60, 60)};
    return one;
  }

  std::mt19937 random_;
};

hybrid::Options to(double accuracy) {
  return {.accuracy = accuracy, .max_time = 0.06};
}

std::string kind_of(const impact::OutcomeSlopes& outcome) {
  return outcome.name.substr(outcome.name.find('.') + 1);
}

/// How large outcomes of one kind are.
double size_of(const Sensitivity& slopes, const impact::OutcomeSlopes& outcome) {
  double most = 0;
  for (const auto& one : slopes.outcome)
    if (kind_of(one) == kind_of(outcome)) most = std::max(most, std::abs(one.value.value()));
  return most;
}

/// Largest difference from slopes of order eight of runs at these steps, relative to the slope and to what
/// the outcome changes by as its parameter doubles: the best step, as rounding of runs and their bend oppose.
/// Infinite if some of these runs end in another way.
double deviation(const Sensitivity& slopes, std::size_t c, const impact::Parameter<Bodies>& by, double step) {
  std::vector<Sensitivity> run;
  for (const auto& point : impact::stencil)
    run.push_back(impact::sensitivity(by.model(by.value + point.offset * step), {}, to(1e-12)));
  for (const auto& one : run)
    if (one.ending != slopes.ending) return infinity;
  double worst = 0;
  for (std::size_t i = 0; i < slopes.outcome.size(); ++i) {
    const auto& outcome = slopes.outcome[i];
    if (!outcome.slope[c]) continue;
    const double expected =
        impact::stencil_slope(step, [&](std::size_t k) { return run[k].outcome.at(i).value.value(); });
    const double natural = std::max(std::abs(expected), size_of(slopes, outcome) / (100 * by.step));
    worst = std::max(worst, std::abs(*outcome.slope[c] - expected) / natural);
  }
  return worst;
}

void compare(int dimension, const contact::Law& law, const Tangential& tangential, int count,
             double tolerance) {
  Scenes scenes(7);
  for (int n = 0; n < count; ++n) {
    const auto bodies = scenes.next(dimension, law, tangential);
    const auto all = impact::parameters(bodies);
    const std::vector<impact::Parameter<Bodies>> some = {all[scenes.below(all.size())],
                                                         all[scenes.below(all.size())]};
    const auto slopes = impact::sensitivity(bodies, some, to(1e-10));
    BOOST_TEST_REQUIRE(slopes.outcome.size() > 6);
    for (std::size_t c = 0; c < some.size(); ++c)
      BOOST_TEST_CONTEXT("scene " << n << " by " << some[c].name) {
        const double worst = std::min(deviation(slopes, c, some[c], 0.03 * some[c].step),
                                      deviation(slopes, c, some[c], 0.003 * some[c].step));
        BOOST_TEST(worst < tolerance);
      }
  }
}

/// No contact yet.
Bodies ball_on_floor(double mass, double radius, const Vector3& velocity, const Vector3& spin = {}) {
  const double moment = 0.4 * mass * radius * radius;
  Bodies bodies{.dimension = 2};
  bodies.body.push_back({.name = "ball",
                         .mass = mass,
                         .inertia = {moment, moment, moment},
                         .spheres = {{{}, radius}},
                         .position = {0, radius, 0},
                         .velocity = velocity,
                         .spin = spin});
  bodies.plane.push_back({.name = "floor", .point = {}, .normal = {0, 1, 0}, .velocity = {}});
  return bodies;
}

/// A ball that slides on a plane while it strikes it.
Bodies sliding(const Tangential& tangential) {
  auto bodies = ball_on_floor(0.1, 0.02, {3, -1, 0});
  bodies.contact.push_back(
      {.a = {0, -1}, .b = {0, 0}, .law = contact::Hertz(1e9), .tangential = tangential, .share = 0});
  return bodies;
}

double slope(const Sensitivity& slopes, const std::string& outcome, const std::string& parameter) {
  for (std::size_t c = 0; c < slopes.parameter.size(); ++c)
    for (const auto& one : slopes.outcome)
      if (slopes.parameter[c].name == parameter && impact::name_of(one) == outcome)
        return one.slope[c].value();
  throw std::runtime_error("no slope of " + outcome + " by " + parameter);
}

Sensitivity all_slopes(const Bodies& bodies) {
  return impact::sensitivity(bodies, impact::parameters(bodies), to(1e-10));
}

}  // namespace

BOOST_AUTO_TEST_CASE(slopes_in_the_plane_are_those_of_differences) {
  const contact::Law laws[] = {contact::Hertz(1e9), contact::Linear(1e6),
                               contact::Viscoelastic{1e9, 1e5, 1.5}, contact::Viscoelastic{1e6, 30, 1},
                               contact::Viscoelastic{1e7, 0, 1.25}};
  for (const auto& law : laws)
    for (const auto& tangential : {Tangential{}, rigid, spring, mindlin})
      BOOST_TEST_CONTEXT(contact::name(law) << " " << model::name(tangential.law))
  compare(2, law, tangential, 2, 1e-6);
}

BOOST_AUTO_TEST_CASE(slopes_in_space_are_those_of_differences) {
  compare(3, contact::Hertz(1e9), {}, 3, 1e-7);
  compare(3, contact::Viscoelastic{1e9, 1e5, 1.5}, {}, 2, 1e-7);
  compare(3, contact::Hertz(1e9), {TangentialLaw::mindlin, 3, 0.8e9}, 1, 1e-6);
}

// Near rest the direction of a slip is rounding, and slopes of it are not resolved: no slip is left behind
// the event, and what leaves rest again does so against the friction that has held it.
BOOST_AUTO_TEST_CASE(slopes_in_space_pass_slips_that_come_to_rest_and_leave_it) {
  const contact::Law laws[] = {contact::Hertz(1e9), contact::Viscoelastic{1e9, 1e5, 1.5},
                               contact::Viscoelastic{1e6, 30, 1}};
  for (const auto& law : laws) BOOST_TEST_CONTEXT(contact::name(law))
  compare(3, law, {TangentialLaw::rigid, 0.5, 0}, 1, 1e-7);
}

// All of a slip's friction is mu times the normal force, whatever the ball does; the spin follows.
BOOST_AUTO_TEST_CASE(slopes_of_a_ball_that_slides_are_those_by_hand) {
  const auto found = all_slopes(sliding(rigid));
  const double mass = 0.1, radius = 0.02, mu = 0.2, normal = 2 * mass;
  const double by_friction = -normal / mass;
  BOOST_TEST(std::abs(slope(found, "bodies[0].velocity[0]", "contact[0].friction") - by_friction) < 1e-9);
  BOOST_TEST(std::abs(slope(found, "bodies[0].velocity[0]", "body[0].velocity[1]") - 2 * mu) < 1e-9);
  BOOST_TEST(std::abs(slope(found, "bodies[0].velocity[0]", "body[0].velocity[0]") - 1) < 1e-9);
  BOOST_TEST(std::abs(slope(found, "bodies[0].velocity[0]", "body[0].mass")) < 1e-8);
  BOOST_TEST(std::abs(slope(found, "contacts[0].normal_impulse", "body[0].mass") - 2) < 1e-9);
  const double spin = -normal * radius / (0.4 * mass * radius * radius);
  BOOST_TEST(std::abs(slope(found, "bodies[0].spin", "contact[0].friction") / spin - 1) < 1e-9);
  // The contact lasts as k^{-2/5}, and the ball's fall to it as the height over the speed.
  const double time = found.outcome.back().value.value();
  BOOST_TEST(found.outcome.back().name == "time");
  BOOST_TEST(std::abs(slope(found, "time", "contact[0].stiffness") * 1e9 / time + 0.4) < 1e-8);
  BOOST_TEST(std::abs(slope(found, "time", "body[0].position[1]") - 1) < 1e-8);
}

// What units cannot change: outcomes of lengths, masses and times that all grow.
BOOST_AUTO_TEST_CASE(slopes_know_that_units_do_not_matter) {
  for (const auto& tangential : {rigid, spring, mindlin}) {
    const auto bodies = sliding(tangential);
    const auto found = all_slopes(bodies);
    const auto by = [&](const char* name, double value) {
      return value * slope(found, "bodies[0].velocity[0]", name);
    };
    double mass = by("body[0].mass", 0.1) + by("body[0].inertia", bodies.body[0].inertia.e3) +
                  by("contact[0].stiffness", 1e9);
    if (tangential.has_spring()) mass += by("contact[0].tangential_stiffness", tangential.stiffness);
    BOOST_TEST(std::abs(mass) < 1e-9);
  }
}

// Where bodies are moves much by a spin or a velocity that has acted for long; what is resolved does not.
BOOST_AUTO_TEST_CASE(slopes_do_not_lose_digits_on_the_way_to_a_contact) {
  const auto pair = [](double flight) {
    constexpr double masses[] = {0.015458, 0.057152}, radius = 0.01;
    Bodies bodies{.dimension = 2};
    for (int i = 0; i < 2; ++i) {
      const double moment = 0.4 * masses[i] * radius * radius;
      bodies.body.push_back({.name = "",
                             .mass = masses[i],
                             .inertia = {moment, moment, moment},
                             .spheres = {{{}, radius}},
                             .position = i == 0 ? Vector3{-0.0145765, 0, 0} : Vector3{0, 0.0145358, 0},
                             .velocity = i == 0 ? Vector3{1, 0, 0} : Vector3{0, 0.207865, 0},
                             .spin = {0, 0, i == 0 ? -1.364 : 0.0}});
      bodies.body[i].position = bodies.body[i].position + flight * bodies.body[i].velocity;
    }
    bodies.contact.push_back({.a = {0, 0},
                              .b = {1, 0},
                              .law = contact::Viscoelastic{7.017e14, 2.881e6, 1.5},
                              .tangential = {TangentialLaw::spring, 0.4198, 3.161e11}});
    for (const auto& one : impact::parameters(bodies))
      if (one.name == "body[0].spin") return impact::sensitivity(bodies, {one}, to(1e-8));
    throw std::runtime_error("no spin");
  };
  const auto far = pair(0), near = pair(1.08e-3);
  for (const char* outcome : {"bodies[0].spin", "bodies[1].spin", "bodies[0].velocity[0]"})
    BOOST_TEST_CONTEXT(outcome)
  BOOST_TEST(std::abs(slope(far, outcome, "body[0].spin") / slope(near, outcome, "body[0].spin") - 1) < 2e-9);
}

// Runs allow guards of friction some noise: slopes pass them where a run has. This ball sticks until just
// before the end, whose force is a millionth of its peak; it rebounds with the speed it came with.
BOOST_AUTO_TEST_CASE(friction_that_gives_way_next_to_the_end_leaves_a_rebound_alone) {
  auto bodies = ball_on_floor(0.0546, 0.01, {0.0292, -1, 0}, {0, 0, -4.92});
  bodies.contact.push_back({.a = {0, -1},
                            .b = {0, 0},
                            .law = contact::Hertz(4.7e14),
                            .tangential = {TangentialLaw::rigid, 0.0359, 0}});
  for (const auto& one : impact::parameters(bodies)) {
    if (one.name != "body[0].mass" && one.name != "contact[0].stiffness") continue;
    const auto found = impact::sensitivity(bodies, {one}, to(1e-8));
    BOOST_TEST(std::abs(one.value * slope(found, "bodies[0].velocity[1]", one.name)) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(equal_moments_move_together) {
  auto bodies = sliding(rigid);
  bodies.dimension = 3;
  for (const auto& one : impact::parameters(bodies)) BOOST_TEST(one.name != "body[0].inertia[1]");
  const impact::Parameter<Bodies> alone{"moment", bodies.body[0].inertia.e2, 1e-7,
                                        [bodies](double value, Bodies& moved) {
                                          moved = bodies;
                                          moved.body[0].inertia.e2 = value;
                                        }};
  BOOST_CHECK_THROW(impact::sensitivity(bodies, {alone}), InvalidParameter);
}

BOOST_AUTO_TEST_CASE(laws_that_yield_and_exponents_are_refused) {
  auto bodies = sliding(rigid);
  auto law = contact::Viscoelastic{1e9, 0, 1.4};
  bodies.contact[0].law = law;
  const impact::Parameter<Bodies> exponent{"exponent", 1.4, 1e-3,
                                           [bodies, law](double value, Bodies& moved) mutable {
                                             law.exponent = value;
                                             moved = bodies;
                                             moved.contact[0].law = law;
                                           }};
  BOOST_CHECK_THROW(impact::sensitivity(bodies, {exponent}), InvalidParameter);
  bodies.contact[0].law = contact::state(contact::WaltonBraun(1e6, 2e6));
  BOOST_CHECK_THROW(impact::sensitivity(bodies, {}), InvalidParameter);
}

// Its spring holds to the end, and what it loses grows like the inverse root of a depth that is rounding:
// these slopes were off by up to five times.
BOOST_AUTO_TEST_CASE(what_a_faded_spring_has_lost_has_no_slopes_and_a_note) {
  auto bodies = sliding({TangentialLaw::mindlin, 1e6, 2.5e7});
  bodies.contact[0].law = contact::Linear(2.5e8);
  const auto found = all_slopes(bodies);
  const auto named = [](const auto& list, const std::string& what) {
    return std::find_if(list.begin(), list.end(), [&](const auto& one) { return name_of(one) == what; });
  };
  const auto rescale = named(found.outcome, "contacts[0].losses.rescale");
  BOOST_TEST_REQUIRE((rescale != found.outcome.end()));
  for (const auto& one : rescale->slope) BOOST_TEST(!one.has_value());
  for (const auto& one : named(found.outcome, "contacts[0].normal_impulse")->slope)
    BOOST_TEST(one.has_value());
  BOOST_TEST(std::ranges::any_of(found.notes, [](const auto& note) {
    return note.outcomes == std::vector<std::string>{"contacts[0].losses.rescale"};
  }));
}

// It lets go at 10⁻¹⁰ of its deepest point.
BOOST_AUTO_TEST_CASE(a_note_says_how_far_slopes_of_a_fading_spring_may_be_off) {
  auto bodies = sliding({TangentialLaw::mindlin, 20, 2.5e7});
  bodies.contact[0].law = contact::Linear(2.5e8);
  const auto noted = [](const Sensitivity& slopes) {
    double error = 0;
    for (const auto& note : slopes.notes)
      if (note.outcomes == std::vector<std::string>{"contacts[0].losses.rescale"}) error = note.error;
    return error;
  };
  const auto by = std::string("contact[0].stiffness"), of = std::string("contacts[0].losses.rescale");
  const auto found = all_slopes(bodies);
  const auto loss = [&](double share) {
    auto moved = bodies;
    moved.contact[0].law = contact::Linear(2.5e8 * (1 + share));
    return impact::simulate(moved, {.accuracy = 1e-12}).contacts[0].losses.rescale;
  };
  const double difference = (loss(1e-3) - loss(-1e-3)) / (2e-3 * 2.5e8);
  const double off = std::abs(slope(found, of, by) / difference - 1);
  BOOST_TEST(noted(found) > 0);
  BOOST_TEST(off < std::max(noted(found), 1e-5));
}
