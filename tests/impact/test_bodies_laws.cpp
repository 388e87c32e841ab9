// Contacts of bodies whose laws yield and adhere: rows of balls against numbers computed in extended
// precision elsewhere, and closed forms of their friction.
#define BOOST_TEST_MODULE impact bodies laws
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/contact/stated_law.hpp"
#include "mariotte/contact/tabulated.hpp"
#include "mariotte/contact/thornton.hpp"
#include "mariotte/contact/thornton_ning.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "support/reference_laws.hpp"

using namespace mariotte;
using hybrid::Ending;
using model::TangentialLaw;

namespace {

constexpr double radius = 1;
const Vector3 along{0.8, 0.6, 0};

model::Body ball(double mass, double place, double velocity) {
  const double moment = 0.4 * mass * radius * radius;
  return {.mass = mass,
          .inertia = {moment, moment, moment},
          .spheres = {{{}, radius}},
          .position = place * along,
          .velocity = velocity * along};
}

/// Where the contact is with an infinite mass, a plane.
void join(model::Bodies& bodies, const model::Chain& chain, std::size_t j, double place) {
  const bool left = !std::isfinite(chain.mass[j]), right = !std::isfinite(chain.mass[j + 1]);
  const Index last = std::ssize(bodies.body) - 1;
  model::BodyContact contact{.a = {last, 0}, .b = {last + 1, 0}, .law = chain.law[j]};
  contact.tangential = {TangentialLaw::rigid, 0.3, 0};
  contact.touching = chain.gap[j] == 0;
  if (left || right) {
    const Vector3 face = (left ? place + radius : place + radius + chain.gap[j]) * along;
    bodies.plane.push_back({.point = face,
                            .normal = left ? along : -1.0 * along,
                            .velocity = chain.velocity[left ? j : j + 1] * along});
    contact.a = {std::ssize(bodies.plane) - 1, -1};
    contact.b = {left ? last + 1 : last, 0};
  }
  bodies.contact.push_back(contact);
}

/// The row of a chain as balls in the plane, on a line of any direction.
model::Bodies row_of(const model::Chain& chain) {
  model::Bodies bodies{.dimension = 2};
  double place = 0;
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    if (i > 0) {
      join(bodies, chain, i - 1, place);
      place += 2 * radius + chain.gap[i - 1];
    }
    if (std::isfinite(chain.mass[i])) bodies.body.push_back(ball(chain.mass[i], place, chain.velocity[i]));
  }
  bodies.named = std::ssize(bodies.contact);
  return bodies;
}

std::vector<double> finite(const std::vector<double>& mass, const std::vector<double>& values) {
  std::vector<double> list;
  for (std::size_t i = 0; i < mass.size(); ++i)
    if (std::isfinite(mass[i])) list.push_back(values[i]);
  return list;
}

/// Velocities to 1e-8 of the largest, where a gap leaves indentations eight digits or more.
void check_row(const nlohmann::json& c, double until) {
  const auto chain = test::chain_of(c);
  const auto impact = impact::simulate(row_of(chain), {.accuracy = 1e-10, .max_time = until});
  const auto expected = finite(chain.mass, test::sizes(c.at("velocity_after")));
  double most = 0, error = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    most = std::max(most, std::abs(expected[i]));
    error = std::max(error, norm(impact.body[i].velocity - expected[i] * along));
  }
  BOOST_TEST(error <= 1e-8 * most, impact.message << error);
  const double energy = impact.energy.initial;
  BOOST_TEST(std::abs(impact.energy.residual) <= 1e-8 * energy);
  for (const auto loss : impact::each_loss) BOOST_TEST((impact.energy.losses.*loss) >= -1e-9 * energy);
}

model::Bodies oblique(const contact::Law& law, const model::Tangential& tangential, double slip) {
  model::Bodies bodies{.dimension = 3, .plane = {{.normal = {0, 0, 1}}}};
  bodies.body.push_back(ball(2, 0, 0));
  bodies.body[0].position = {0, 0, radius};
  bodies.body[0].velocity = {0.6 * slip, 0.8 * slip, -1};
  bodies.contact.push_back(
      {.a = {0, -1}, .b = {0, 0}, .law = law, .tangential = tangential, .share = 0, .touching = true});
  return bodies;
}

contact::Law named(std::string_view name) {
  const contact::LawNumbers numbers{.loading_stiffness = 1e4,
                                    .unloading_stiffness = 3e4,
                                    .effective_modulus = 1e4,
                                    .effective_radius = 1,
                                    .yield_pressure = 800,
                                    .work_of_adhesion = 2};
  for (const auto& law : contact::named_laws)
    if (law.name == name) return law.make(numbers);
  throw std::runtime_error("no such law");
}

/// Speed after over speed before of the same ball at normal incidence.
double restitution(const contact::Law& law) {
  const model::Chain chain{.mass = {infinity, 2}, .law = {law}, .gap = {0}, .velocity = {0, -1}};
  return impact::simulate(chain, {.accuracy = 1e-11}).velocity[1];
}

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_are_those_of_the_references) {
  for (const auto& c : test::law_cases("pairs.json"))
    if (c.at("ending") == "separated") BOOST_TEST_CONTEXT(c.at("family") << " " << c.at("velocity")) {
        const double time = c.at("events").back().at("time");
        check_row(c, 1.01 * time);
      }
}

BOOST_AUTO_TEST_CASE(rows_are_those_of_the_references) {
  for (const auto& c : test::law_cases("chains.json"))
    if (!c.value("precompressed", false)) BOOST_TEST_CONTEXT(c.at("mass").size() << " balls") {
        check_row(c, c.at("end_time"));
      }
}

BOOST_AUTO_TEST_CASE(gross_slip_is_coulombs_share_of_the_normal_impulse) {
  const double mu = 0.1, slip = 5;
  for (const auto* name : {"walton-braun", "thornton"}) {
    const auto law = named(name);
    const double gained = mu * (1 + restitution(law));
    const auto impact =
        impact::simulate(oblique(law, {TangentialLaw::rigid, mu, 0}, slip), {.accuracy = 1e-10});
    const auto& end = impact.body[0];
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(norm(end.velocity - Vector3{0.6 * (slip - gained), 0.8 * (slip - gained), gained / mu - 1}) <
                 1e-9 * slip);
      BOOST_TEST(norm(end.spin - 2.5 * gained / radius * Vector3{-0.8, 0.6, 0}) < 1e-8);
      BOOST_TEST(impact.energy.losses.plastic > 0.1 * impact.energy.initial / (1 + slip * slip));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_rigid_stick_keeps_five_sevenths) {
  for (const auto* name : {"walton-braun", "thornton"}) {
    const auto impact = impact::simulate(oblique(named(name), {TangentialLaw::rigid, 0.4, 0}, 0.3));
    const auto& v = impact.body[0].velocity;
    BOOST_TEST(norm(v - Vector3{0.6 * 0.3 * 5 / 7, 0.8 * 0.3 * 5 / 7, restitution(named(name))}) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(there_is_no_friction_while_adhesion_pulls) {
  for (const auto* name : {"jkr", "dmt", "thornton-ning"}) {
    const double mu = 0.05, slip = 9;
    const auto impact = impact::simulate(oblique(named(name), {TangentialLaw::rigid, mu, 0}, slip),
                                         {.accuracy = 1e-10, .max_time = 5});
    const auto& c = impact.contacts[0];
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(norm(c.tangential_impulse) > mu * c.normal_impulse * (1 + 1e-4));
      BOOST_TEST(impact.events.front().of(model::BodyEvent::slip).empty());
      BOOST_TEST(std::abs(impact.energy.residual) < 1e-9 * impact.energy.initial);
      BOOST_TEST(c.losses.friction > 0);
    }
  }
}

// The well of adhesion makes it a thousand million times faster.
BOOST_AUTO_TEST_CASE(what_hardly_moves_is_drawn_in) {
  for (const auto* name : {"jkr", "thornton-ning"}) {
    auto bodies = oblique(named(name), {TangentialLaw::rigid, 0.2, 0}, 0);
    bodies.body[0].velocity = {3e-10, 0, -1e-9};
    const model::Chain chain{.mass = {infinity, 2}, .law = {named(name)}, .gap = {0}, .velocity = {0, -1e-9}};
    const hybrid::Options options{.accuracy = 1e-10, .max_time = 0.2};
    const auto impact = impact::simulate(bodies, options);
    const auto row = impact::simulate(chain, options);
    BOOST_TEST((impact.ending == Ending::time_limit), impact.message);
    BOOST_TEST(impact.contacts[0].stored < 0);
    BOOST_TEST(std::abs(impact.body[0].velocity.e3 - row.velocity[1]) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(a_ball_falls_back_into_its_dent) {
  const auto law = named("thornton");
  model::Bodies bodies{.dimension = 2, .gravity = {0, -10, 0}, .plane = {{.normal = {0, 1, 0}}}};
  bodies.body.push_back(ball(2, 0, 0));
  bodies.body[0].position = {0, radius + 0.05, 0};
  bodies.contact.push_back({.a = {0, -1}, .b = {0, 0}, .law = law});
  const model::Chain chain{
      .mass = {infinity, 2}, .law = {law}, .gap = {0.05}, .velocity = {0, 0}, .gravity = 10};
  const hybrid::Options options{.accuracy = 1e-10, .max_time = 0.45};
  const auto impact = impact::simulate(bodies, options);
  const auto row = impact::simulate(chain, options);
  BOOST_TEST(impact.contacts[0].periods.size() >= 2U);
  BOOST_TEST(std::abs(impact.body[0].velocity.e2 - row.velocity[1]) < 1e-8);
  BOOST_TEST(std::abs(impact.energy.losses.plastic - row.energy.plastic) < 1e-8);
}

// Two balls beat a third, which keeps a dent, while another contact pushes by a power of its depth.
BOOST_AUTO_TEST_CASE(a_dent_closes_where_it_begins_while_others_push) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  Index again = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<contact::Law> powers{contact::Hertz{10}, contact::Linear{4}};
    const std::vector<contact::Law> yielding{contact::state(contact::WaltonBraun(1000, 10000)),
                                             contact::state(contact::Thornton(5000, 1, 30)),
                                             contact::state(contact::ThorntonNing(5000, 1, 30, 1e-3))};
    const model::Chain chain{.mass = {1, 1, 0.5 + share(random)},
                             .law = {powers[i % 2], yielding[i % 3]},
                             .gap = {0.1 * share(random), 0.01},
                             .velocity = {2, share(random), 0}};
    const hybrid::Options options{.accuracy = 1e-10, .max_time = 4};
    auto bodies = row_of(chain);
    for (auto& contact : bodies.contact) contact.tangential = {};
    const auto impact = impact::simulate(bodies, options);
    const auto row = impact::simulate(chain, options);
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST((impact.ending == row.ending));
      for (int ball : {0, 1, 2})
        BOOST_TEST(norm(impact.body[ball].velocity - row.velocity[ball] * along) <= 1e-9);
      BOOST_TEST(impact.contacts[1].periods.size() == row.contacts[1].periods.size());
    }
    again += row.contacts[1].periods.size() > 1;
  }
  BOOST_TEST(again > 20);
}

BOOST_AUTO_TEST_CASE(what_has_no_meaning_is_refused) {
  const auto slip = oblique(named("thornton"), {TangentialLaw::mindlin, 0.1, 1e4}, 1);
  BOOST_CHECK_THROW(impact::simulate(slip), InvalidParameter);
  auto stays = oblique(named("jkr"), {}, 1);
  BOOST_CHECK_THROW(impact::simulate(stays), InvalidParameter);
  stays.body[0].velocity = {};
  BOOST_CHECK_THROW(impact::simulate(stays, {.max_time = 1}), InvalidParameter);
}

// The light ball shakes: contacts let go while they are deep, and push again when the wall throws it back.
BOOST_AUTO_TEST_CASE(a_light_ball_between_a_wall_and_a_heavy_one_grips_as_in_a_chain) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  Index grips = 0;
  for (int i = 0; i < 200; ++i) {
    const double light = std::pow(10, -4 + 3 * share(random));
    const contact::PowerLaw law{.stiffness = 1e4,
                                .damping = std::pow(10, 1 + 2 * share(random)) * std::sqrt(light),
                                .exponent = i % 2 == 0 ? 1 : 1.5};
    const model::Chain chain{.mass = {infinity, light, 1},
                             .law = {law, law},
                             .gap = {0.01, 0.01 * share(random)},
                             .velocity = {0, -1, -share(random)}};
    const auto impact = impact::simulate(row_of(chain), {.accuracy = 1e-10, .max_time = 10});
    const auto expected = impact::simulate(chain, {.accuracy = 1e-10, .max_time = 10});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST((impact.ending == expected.ending));
      for (int ball : {0, 1})
        BOOST_TEST(norm(impact.body[ball].velocity - expected.velocity[ball + 1] * along) <= 1e-8);
    }
    for (const auto& event : impact.events) grips += std::ssize(event.of(model::BodyEvent::grip));
  }
  BOOST_TEST(grips > 30);
}

// It falls so far that its first steps in the contact are shorter than what rounding makes of the gap.
BOOST_AUTO_TEST_CASE(a_strong_damper_stops_a_fallen_ball_as_in_a_chain) {
  struct Fall {
    double exponent, stiffness, damping, mass, speed, gap;
  };
  for (const auto& one : {Fall{1.05, 2304542.66, 142.134943, 1.11495e-3, 0.0112488126, 9.79048523e-5},
                          Fall{1.1, 3958523.73, 11.6505284, 6.00435e-5, 0.0257331878, 6.92342375e-4},
                          Fall{1.1, 4e6, 97, 5e-5, 0.02, 6.4e-4},
                          Fall{1.15, 6799574.76, 301.491922, 3.31402e-4, 0.0123870815, 6.11005381e-4},
                          Fall{1.25, 20062209.1, 71817.0442, 8.61686e-5, 0.0401370078, 9.20616344e-4}}) {
    const model::Chain chain{
        .mass = {infinity, one.mass},
        .law = {contact::PowerLaw{
            .stiffness = one.stiffness, .damping = one.damping, .exponent = one.exponent}},
        .gap = {one.gap},
        .velocity = {0, -one.speed}};
    const double soon = one.gap / one.speed + 2e-4;
    const auto impact = impact::simulate(row_of(chain), {.accuracy = 1e-10, .max_time = soon});
    const auto expected = impact::simulate(chain, {.accuracy = 1e-10, .max_time = soon});
    BOOST_TEST((impact.ending == Ending::separated || impact.ending == Ending::time_limit), impact.message);
    BOOST_TEST(norm(impact.body[0].velocity - expected.velocity[1] * along) <= 1e-9 * one.speed);
  }
}

// Adhesion pulls what comes in more strongly than it is pressed afterwards.
BOOST_AUTO_TEST_CASE(peaks_of_what_pulls_are_those_of_the_push) {
  for (const bool damped : {false, true}) {
    nlohmann::json law = {
        {"law", "jkr"}, {"effective_modulus", 100}, {"effective_radius", 1}, {"work_of_adhesion", 0.4}};
    if (damped) law["damping"] = 60;
    model::Chain pair{.mass = {infinity, 1}, .law = {test::law_of(law)}, .gap = {1e-2}, .velocity = {0, -1}};
    for (const double until : {0.03, 0.05, 0.08, 0.3}) {
      const auto chain = impact::simulate(pair, {.accuracy = 1e-10, .max_time = until});
      const auto bodies = impact::simulate(row_of(pair), {.accuracy = 1e-10, .max_time = until});
      BOOST_TEST(std::abs(bodies.contacts[0].peak_force - chain.contacts[0].peak_force) < 1e-8);
      BOOST_TEST(std::abs(bodies.contacts[0].peak_indentation - chain.contacts[0].peak_indentation) < 1e-9);
    }
  }
}

// It runs flat below the weight: nothing rests there, and the body sinks on.
BOOST_AUTO_TEST_CASE(a_curve_may_end_below_the_weight) {
  const contact::Law flat = contact::SharedLaw(std::make_shared<contact::Tabulated>(
      std::vector<contact::LawPoint>{{0.01, 0.1}, {0.02, 0.5}, {0.05, 0.6}}));
  auto bodies = row_of({.mass = {infinity, 1}, .law = {flat}, .gap = {0.01}, .velocity = {0, -0.1}});
  bodies.gravity = -0.7 * along;
  const auto impact = impact::simulate(bodies, {.accuracy = 1e-10, .max_time = 2});
  BOOST_TEST((impact.ending == Ending::time_limit), impact.message);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-9);
}
