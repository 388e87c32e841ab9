// Bodies that adhesion holds together, and rows whose dents stay.
#define BOOST_TEST_MODULE adhesion and dents
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/reference.hpp"
#include "support/reference_laws.hpp"

using namespace mariotte;
using hybrid::Ending;

namespace {

constexpr double modulus = 1.3, radius = 0.8, work = 0.002;

const nlohmann::json sticky = {
    {"law", "jkr"}, {"effective_modulus", modulus}, {"effective_radius", radius}, {"work_of_adhesion", work}};

/// √a, indentation and stiffness where the force is zero.
const double s = std::sqrt(2 * std::numbers::pi * work / modulus);
const double u = std::sqrt(std::cbrt(9 * std::numbers::pi * work * radius * radius / (2 * modulus)));
const double rest = std::pow(u, 4) / (3 * radius);
const double stiffness =
    modulus * (8 * std::pow(u, 5) / radius - 6 * s * u * u) / (4 * u * u * u / radius - s);

/// Balls of mass 1 bonded to each other.
model::Chain bonded(std::vector<double> velocity) {
  const auto contacts = velocity.size() - 1;
  return {.mass = std::vector<double>(velocity.size(), 1),
          .law = std::vector<contact::Law>(contacts, test::law_of(sticky)),
          .gap = std::vector<double>(contacts, -rest),
          .velocity = std::move(velocity),
          .precompressed = true};
}

double hertz(double square) {
  return std::sqrt(square) / (2 * std::numbers::pi);
}

model::Chain plastic_row(std::size_t balls) {
  const nlohmann::json law = {
      {"law", "thornton"}, {"effective_modulus", 1}, {"effective_radius", 1}, {"yield_pressure", 0.15}};
  auto row = test::equal_masses(std::vector<contact::Law>(balls - 1, test::law_of(law)),
                                std::vector<double>(balls, 0.0));
  row.velocity[0] = 1;
  return row;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_captured_pair_rings_at_the_frequency_of_its_well) {
  auto pair = bonded({0.02, 0});
  pair.gap = {0.01};
  pair.precompressed = false;
  const auto impact = impact::simulate(pair);
  BOOST_TEST((impact.ending == Ending::bound), impact.message);
  BOOST_TEST_REQUIRE(impact.bound_frequency.size() == 1u);
  BOOST_TEST(impact.bound_frequency[0] == hertz(2 * stiffness), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(impact.events.size() == 1u);
  BOOST_TEST(!impact.contacts[0].periods[0].end);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-12);
}

// Beyond critical damping no turn of the rate tells that a pair is held.
BOOST_AUTO_TEST_CASE(a_pair_that_creeps_to_rest_in_its_well_is_bound) {
  for (const char* name : {"jkr", "dmt"})
    for (const double damping : {4.0, 8.0, 20.0, 100.0}) {
      const nlohmann::json law = {{"law", name},
                                  {"effective_modulus", 0.75},
                                  {"effective_radius", 1},
                                  {"work_of_adhesion", 1e-3},
                                  {"damping", damping}};
      const model::Chain pair{.mass = {1, 1}, .law = {test::law_of(law)}, .gap = {0.1}, .velocity = {1, 0}};
      const auto expect_bound = [&](const auto& model, double accuracy) {
        const auto impact = impact::simulate(model, {.accuracy = accuracy});
        BOOST_TEST((impact.ending == Ending::bound), name << ' ' << damping << impact.message);
        BOOST_TEST(test::difference(impact.velocity, {0.5, 0.5}) <= accuracy);
        BOOST_TEST(impact.time < 5000);
      };
      for (const double accuracy : {1e-6, 1e-10}) {
        expect_bound(pair, accuracy);
        expect_bound(model::as_network(pair), accuracy);
      }
    }
}

BOOST_AUTO_TEST_CASE(three_bonded_balls_have_the_modes_of_a_free_row) {
  const auto impact = impact::simulate(bonded({1e-4, 0, 0}));
  BOOST_TEST((impact.ending == Ending::bound), impact.message);
  BOOST_TEST_REQUIRE(impact.bound_frequency.size() == 2u);
  BOOST_TEST(impact.bound_frequency[0] == hertz(stiffness), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(impact.bound_frequency[1] == hertz(3 * stiffness), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_time_limit_keeps_what_is_bound_ringing) {
  const auto impact = impact::simulate(bonded({1e-4, 0, 0}), {.max_time = 100});
  BOOST_TEST((impact.ending == Ending::time_limit), impact.message);
  BOOST_TEST(impact.time == 100);
  BOOST_TEST(impact.bound_frequency.empty());
  BOOST_TEST(std::abs(impact.velocity[0] + impact.velocity[1] + impact.velocity[2] - 1e-4) < 1e-13);
}

BOOST_AUTO_TEST_CASE(bonded_balls_at_rest_stay_so_without_events) {
  auto row = bonded({0, 0, 0, 1});
  row.gap[2] = 1;
  row.velocity[3] = 2;
  const auto impact = impact::simulate(row, {.max_time = 50});
  BOOST_TEST(impact.events.size() == 1u);
  BOOST_TEST(std::abs(impact.velocity[0]) < 1e-12);
}

// The motion after the turn has even powers of time only. That of order 16 vanishes if the pull is so large a
// share of the force there, that of order 20 at the other one, so a step must not be as long as they allow.
BOOST_AUTO_TEST_CASE(a_constant_pull_costs_nothing_where_a_last_coefficient_vanishes) {
  for (const double pull : {0.043564132, 0.221004157, 0.3})
    for (const double accuracy : {1e-8, 1e-9, 1e-10, 1e-12, 1e-14}) {
      const nlohmann::json law = {{"law", "dmt"},
                                  {"effective_modulus", 0.75},
                                  {"effective_radius", 1},
                                  {"work_of_adhesion", pull / (2 * std::numbers::pi)}};
      const double speed = std::sqrt(0.8 - 2 * pull);  // as deep as the force is 1
      const model::Chain ball{
          .mass = {1, infinity}, .law = {test::law_of(law)}, .gap = {0.01}, .velocity = {speed, 0}};
      const auto impact = impact::simulate(ball, {.accuracy = accuracy});
      BOOST_TEST_CONTEXT("pull " << pull << " accuracy " << accuracy)
      BOOST_TEST(std::abs(impact.velocity[0] + speed) <= std::max(accuracy, 1e-14) * speed);
    }
}

BOOST_AUTO_TEST_CASE(contacts_that_adhere_must_not_touch_at_rest) {
  auto pair = bonded({0, 0});
  pair.gap = {0};
  BOOST_CHECK_THROW(impact::simulate(pair), InvalidParameter);
  BOOST_CHECK_THROW(impact::simulate(model::as_network(pair)), InvalidParameter);
  pair.velocity = {0.3, 0};
  BOOST_TEST((impact::simulate(pair).ending == Ending::separated));
}

BOOST_AUTO_TEST_CASE(networks_are_their_chains) {
  for (const auto& c : test::law_cases("chains.json")) {
    const double end = c.at("ending") == "time" ? c.at("end_time").get<double>() : infinity;
    const auto impact = impact::simulate(model::as_network(test::chain_of(c)), {.max_time = end});
    const auto velocity = test::sizes(c.at("velocity_after"));
    BOOST_TEST((impact.ending == (std::isinf(end) ? Ending::separated : Ending::time_limit)), impact.message);
    BOOST_TEST(test::difference(impact.velocity, velocity) < 1e-9);
    for (std::size_t j = 0; j < impact.contacts.size(); ++j)
      BOOST_TEST(std::abs(impact.contacts[j].permanent_indentation -
                          c.at("permanent_indentation")[j].get<double>()) < 1e-9);
  }
}

// Islands are cut from a row that remembers.
BOOST_AUTO_TEST_CASE(islands_of_a_plastic_row_are_the_whole_row) {
  const auto row = plastic_row(12);
  const auto whole = impact::simulate(row, {.islands = hybrid::Islands::never});
  const auto parts = impact::simulate(row, {.islands = hybrid::Islands::always});
  BOOST_TEST((whole.ending == Ending::separated), whole.message);
  BOOST_TEST((parts.ending == Ending::separated), parts.message);
  BOOST_TEST(test::difference(whole.velocity, parts.velocity) < 1e-9);
  for (std::size_t j = 0; j < row.law.size(); ++j) {
    const auto &a = whole.contacts[j], &b = parts.contacts[j];
    BOOST_TEST(std::abs(a.permanent_indentation - b.permanent_indentation) < 1e-9);
    BOOST_TEST(std::abs(a.plastic - b.plastic) < 1e-9);
    BOOST_TEST(a.plastic > 0);
  }
}

// In the wells balls are eight times as fast as before and behind them, where the accuracy is meant.
BOOST_AUTO_TEST_CASE(balls_that_leave_deep_wells_keep_the_accuracy) {
  const auto law = test::law_of({{"law", "dmt"},
                                 {"effective_modulus", 4.8543738721164003},
                                 {"effective_radius", 2.1422442546995564},
                                 {"work_of_adhesion", 0.2565220885857788},
                                 {"damping", 0}});
  const model::Chain chain{
      .mass = {2.2144611955081399, 2.5669933018900792, 0.20301270615039721, 0.15260608076546012},
      .law = {law, law, law},
      .gap = {0.01628172220215492, 0.0028699238876347235, 0.13018508089862213},
      .velocity = {-0.13564159253919517, 0.38775650064447276, 0.44850588314482076, 0.20794899525990718}};
  const std::vector<double> end = {-0.135641592539195, 0.366398415977334, 0.486785426298019,
                                   0.516290749402303};
  const double fastest = 0.584;
  for (const double accuracy : {1e-8, 1e-10, 1e-12}) {
    const auto impact = impact::simulate(chain, {.accuracy = accuracy});
    BOOST_TEST(test::difference(impact.velocity, end) < std::max(accuracy, 2e-12) * fastest);
    const auto linked = impact::simulate(model::as_network(chain), {.accuracy = accuracy});
    BOOST_TEST(test::difference(linked.velocity, end) < std::max(accuracy, 2e-12) * fastest);
  }
}

// Balls that come slowly are drawn into a deep well, where their time is a quadrature that rounding alone may
// leave without a result. Expected: Adams, BDF and a simulator without events.
BOOST_AUTO_TEST_CASE(a_pair_that_is_drawn_in_slowly_yields_at_every_accuracy) {
  const nlohmann::json law = {{"law", "thornton-ning"},
                              {"effective_modulus", 5.0518048298119815},
                              {"effective_radius", 2.0671698862562535},
                              {"yield_pressure", 0.93460007391938416},
                              {"work_of_adhesion", 0.077320017607449082}};
  const model::Chain pair{.mass = {0.54537928450866446, 0.50900458496467826},
                          .law = {test::law_of(law)},
                          .gap = {0.071843077124189553},
                          .velocity = {0.18299786837251664, 0.16141070143012559}};
  for (const double accuracy : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12}) {
    const auto impact =
        impact::simulate(pair, {.accuracy = accuracy, .max_time = 5.3521739374562172, .max_events = 100});
    BOOST_TEST(std::abs(impact.velocity[0] - 0.202677202) < 1e-9 + 10 * accuracy);
    BOOST_TEST(std::abs(impact.contacts[0].peak_indentation - 0.3001483582557) < 1e-12 + 10 * accuracy);
  }
}

// Ball 1 snaps onto ball 2 and draws it away from ball 3, which it touches at rest, before it pushes it
// there.
BOOST_AUTO_TEST_CASE(adhesion_that_snaps_in_draws_a_touching_contact_apart) {
  const auto tip = [](const char* law) {
    nlohmann::json said = {
        {"law", law}, {"effective_modulus", 1}, {"effective_radius", 1}, {"work_of_adhesion", 0.01}};
    return test::law_of(said);
  };
  for (const char* law : {"dmt", "jkr", "brach-dunn"})
    for (const double gap : {0.0, 0.1})
      for (const double accuracy : {1e-6, 1e-10})
        BOOST_TEST_CONTEXT(law << ", gap " << gap << ", accuracy " << accuracy) {
          model::Chain row{.mass = {1, 1, 1},
                           .law = {tip(law), contact::Hertz{1}},
                           .gap = {gap, 0},
                           .velocity = {1, 0, 0}};
          const double snaps = gap;  // at the speed 1
          const auto drawn = impact::simulate(row, {.accuracy = accuracy, .max_time = snaps + 1e-3});
          BOOST_TEST(drawn.velocity[1] < 0);
          BOOST_TEST(drawn.velocity[2] == 0);
          BOOST_TEST(drawn.contacts[1].periods.empty());
          BOOST_TEST(drawn.contacts[1].impulse == 0);
          BOOST_TEST_REQUIRE(drawn.events.size() == 1u);
          BOOST_TEST(drawn.events[0].close == std::vector<Index>{0});
          BOOST_TEST(!drawn.icr[0].has_value());

          const auto network =
              impact::simulate(model::as_network(row), {.accuracy = accuracy, .max_time = snaps + 1e-3});
          BOOST_TEST(network.contacts[1].periods.empty());
          BOOST_TEST(network.velocity[2] == 0);

          // Later it is pushed onto ball 3, with a speed of its own.
          const auto whole = impact::simulate(row, {.accuracy = accuracy, .max_time = snaps + 2});
          BOOST_TEST_REQUIRE(whole.contacts[1].periods.size() == 1u);
          const double meets = whole.contacts[1].periods[0].start;
          BOOST_TEST(meets > snaps + 1e-3);
          const model::Chain pair{.mass = {1, 1}, .law = {row.law[0]}, .gap = {gap}, .velocity = {1, 0}};
          const auto until_then = impact::simulate(pair, {.accuracy = accuracy, .max_time = meets});
          const double moved = 0.5 * (meets + until_then.gap[0] - gap);  // of ball 2, by momentum
          BOOST_TEST(std::abs(moved) < 10 * accuracy);
          BOOST_TEST(std::abs(whole.contacts[1].meeting.approach.value() - until_then.velocity[1]) <
                     10 * accuracy);
        }
}

// Gravity draws ball 2 off the wall in the instant in which ball 1 strikes it. At t it has come back if
// k t^{7/2} 4/35 = g t²/2 [theory page, "Touching at rest"]; if that is soon, it counts as pressed from the
// start.
BOOST_AUTO_TEST_CASE(gravity_draws_a_touching_contact_apart) {
  const auto row = [](double gravity) {
    return model::Chain{.mass = {1, 1, infinity},
                        .law = {contact::Hertz{1e6}, contact::Hertz{1e6}},
                        .gap = {0, 0},
                        .velocity = {1, 0, 0},
                        .gravity = gravity};
  };
  for (const double accuracy : {1e-6, 1e-10}) {
    const hybrid::Options options{.accuracy = accuracy, .max_time = 0.2};
    const auto off = impact::simulate(row(1000), options);
    BOOST_TEST(off.contacts[1].periods.empty());
    BOOST_TEST(off.contacts[1].impulse == 0);
    BOOST_TEST(off.events.size() == 2u);
    const auto back = impact::simulate(row(1), options);
    BOOST_TEST_REQUIRE(back.contacts[1].periods.size() == 1u);
    BOOST_TEST(back.contacts[1].periods[0].start == std::pow(35 / 8.0 / 1e6, 2.0 / 3),
               boost::test_tools::tolerance(0.02));  // ball 1 is slower by a few per cent then
    const auto soon = impact::simulate(row(1e-8), options);
    BOOST_TEST_REQUIRE(soon.contacts[1].periods.size() == 1u);
    BOOST_TEST(soon.contacts[1].periods[0].start == 0);
  }
  // CVODE finds no gap that begins and ends within rounding.
  auto damped = row(3e-5);
  damped.law.assign(2, contact::Viscoelastic{.stiffness = 1e6, .damping = 1000, .exponent = 1.5});
  const auto series = impact::simulate(damped, {.accuracy = 1e-9, .max_time = 0.03});
  const auto steps =
      impact::simulate(damped, {.accuracy = 1e-9, .max_time = 0.03, .flow = flow::Kind::cvode_adams});
  for (std::size_t i = 0; i < 2; ++i) BOOST_TEST(std::abs(series.velocity[i] - steps.velocity[i]) < 1e-8);
}
