#define BOOST_TEST_MODULE the promise of an accuracy
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/contact/dmt.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/doubt.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/impact/network/network_solver.hpp"
#include "mariotte/impact/promise.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

using namespace mariotte;

namespace {

/// Balls between heavy ones at both ends: each contact closes again and again.
model::Chain rattling(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  model::Chain chain;
  const int balls = 7 + static_cast<int>(seed % 3);
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(std::pow(10, uniform(-0.7, 0.7)));
    chain.velocity.push_back(uniform(-1, 1));
  }
  chain.mass.front() = chain.mass.back() = 20;
  chain.velocity.front() = 0.5;
  chain.velocity.back() = -0.5;
  for (int j = 0; j + 1 < balls; ++j) {
    chain.law.push_back(contact::Hertz{std::pow(10, uniform(-1, 1))});
    chain.gap.push_back(uniform(0, 1));
  }
  return chain;
}

auto rounding_makes(double difference) {
  return [=](const hybrid::Options&) { return std::optional(difference); };
}

/// Light balls rattle between heavy ones, which turn rounding into 10⁻⁴; natural modes are exact but for it.
model::Chain light_between_heavy() {
  model::Chain chain{.mass = {5542.1640300826548, 0.0018053410244916151, 0.00026506738045670061,
                              16.966664714855334, 211.01828558440241, 0.003784900860111253,
                              0.00011605863957457904, 0.00016650901483446183, 2191.9213107646883},
                     .law = {},
                     .gap = std::vector<double>(8),
                     .velocity = {1, 0, 0, 0, 0, 0, 0, 0, -1}};
  for (const double stiffness :
       {0.003900737861440393, 89.536093198484565, 682.4833134036586, 81.17191326879508, 17.404275286046644,
        0.0053633632346915972, 42.466776532861545, 0.00095300358166849767})
    chain.law.push_back(contact::Linear{stiffness});
  return chain;
}

/// The last ball presses others for as long as the first one flies: whether they have parted by then is
/// decided by what is left out of so slow an approach.
model::Chain creeping_balls() {
  return {.mass = {2, 0.25, 4, 1},
          .law = {contact::Hertz{10}, contact::Hertz{10}, contact::Hertz{1}},
          .gap = {100, 0, 0},
          .velocity = {1, 0, 0, -1e-5}};
}

/// The fastest ball has a velocity of 1.
template <class Solver, class Model>
void expect_accuracy(const Model& model, const std::vector<double>& truth) {
  for (const double accuracy : {1e-4, 1e-5, 1e-6, 1e-7}) {
    const auto impact = impact::simulate(model, {.accuracy = accuracy});
    BOOST_TEST(impact::difference(impact.velocity, truth, 1) < accuracy);
    BOOST_TEST(impact.estimated_accuracy.has_value());
    const auto brief = Solver().solve(model, {.accuracy = accuracy});
    BOOST_TEST(impact::difference(brief.velocity, truth, 1) < accuracy);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(tighter_runs_are_asked_for_as_the_difference_says) {
  using impact::next_accuracy;
  constexpr double attainable = 16 * epsilon;
  BOOST_TEST(next_accuracy(1e-8, 1e-8, 1e-8, attainable).value() < 1e-9);
  BOOST_TEST(next_accuracy(1e-8, 1e-8, 1e-6, attainable).value() < 1e-11);
  BOOST_TEST(!next_accuracy(1e-15, attainable, 1e-12, attainable));
  BOOST_TEST(next_accuracy(1e-8, 1e-8, 1e-6, 2e-9).value() == 2e-9);
  BOOST_TEST(!next_accuracy(1e-8, 2e-9, 1e-6, 2e-9));
}

BOOST_AUTO_TEST_CASE(runs_stop_when_two_agree) {
  int runs = 0;
  const auto last = impact::keep_promise(
      {.accuracy = 1e-8}, {}, [&](const hybrid::Options&) { return std::optional(++runs < 2 ? 1e-6 : 1e-9); },
      rounding_makes(1));
  BOOST_TEST(runs == 2);
  BOOST_TEST(last == 1e-9);
}

BOOST_AUTO_TEST_CASE(where_runs_never_agree_the_last_one_is_shaken) {
  const auto apart = [](const hybrid::Options&) { return std::optional(1e-6); };
  double near = 0;
  const auto shake = [&](const hybrid::Options& options) {
    near = options.accuracy;
    return std::optional(1e-9);
  };
  BOOST_TEST(impact::keep_promise({.accuracy = 1e-8}, {}, apart, shake) == 1e-9);
  BOOST_TEST(near == 4 * impact::Passage{}.attainable);
}

BOOST_AUTO_TEST_CASE(where_closed_forms_agree_rounding_tells) {
  const auto agree = [](const hybrid::Options&) { return std::optional(1e-15); };
  const auto estimate = [&](const impact::Passage& gone) {
    return impact::keep_promise({.accuracy = 1e-8}, gone, agree, rounding_makes(1e-6));
  };
  BOOST_TEST(estimate({.exact = 7, .cut = 3}) == 1e-6);
  BOOST_TEST(estimate({.exact = 3, .cut = 7}) == 1e-15);
}

// Runs that differ in accuracy share what a phase of CVODE leaves: what the run makes of rounding, it makes
// of that.
BOOST_AUTO_TEST_CASE(a_run_that_magnifies_rounding_magnifies_the_errors_of_cvode) {
  const auto same = [](const hybrid::Options&) { return std::optional(0.0); };
  const auto estimate = [&](const impact::Passage& gone, double shaken) {
    return impact::keep_promise({.accuracy = 1e-11}, gone, same, rounding_makes(shaken));
  };
  const impact::Passage stiff{.bdf = 100, .cvode = 1};
  BOOST_TEST(estimate({}, 1e-5) == 1e-5);
  BOOST_TEST(estimate(stiff, 1e-5) > 1e-3);
  BOOST_TEST(estimate(stiff, 64 * epsilon) < 5e-11);
}

BOOST_AUTO_TEST_CASE(where_two_runs_are_the_same_rounding_tells) {
  const auto same = [](const hybrid::Options&) { return std::optional(0.0); };
  BOOST_TEST(impact::keep_promise({.accuracy = 1e-8}, {}, same, rounding_makes(1e-6)) == 1e-6);
  const auto never = [](const hybrid::Options&) -> std::optional<double> { throw std::logic_error("run"); };
  BOOST_TEST(impact::keep_promise({.accuracy = 1e-15}, {}, never, rounding_makes(1e-6)) == 1e-6);
}

// Eleven decades: the velocities of the last run of modes are 2e-6 off.
BOOST_AUTO_TEST_CASE(a_chain_that_magnifies_rounding_says_so) {
  const auto linear = [](double stiffness) { return contact::Law(contact::Linear{stiffness}); };
  const model::Chain chain{
      .mass = {4.99, 1.178, 0.1648, 0.006037, 0.5504, 836.7, infinity},
      .law = {linear(0.01977), linear(193.1), linear(0.6005), linear(0.08882),
              contact::Viscoelastic{.stiffness = 0.002133, .damping = 0.1079, .exponent = 1}, linear(1)},
      .gap = {0, 0.003542, 0, 0.06577, 0, 0},
      .velocity = {0.7768, -0.01427, -0.1393, -0.3246, -1.1976, -1.3929, 0}};
  const auto exact = impact::simulate(chain, {.flow = flow::Kind::cvode_adams});
  impact::ChainSolver solver;
  for (const double accuracy : {1e-8, 1e-10, 1e-14}) {
    const auto impact = impact::simulate(chain, {.accuracy = accuracy});
    const double error = impact::difference(impact.velocity, exact.velocity, model::reference_speed(chain));
    BOOST_TEST(impact.estimated_accuracy.value() > 1e-8);
    BOOST_TEST(error < 30 * *impact.estimated_accuracy);
    const auto& brief = solver.solve(chain, {.accuracy = accuracy});
    BOOST_TEST(brief.estimated_accuracy.value() > 1e-8);
    BOOST_TEST(brief.velocity == impact.velocity, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(where_a_tighter_run_fails_the_one_before_is_shaken) {
  const auto fails = [](const hybrid::Options&) { return std::optional<double>(); };
  double near = 0;
  const auto shake = [&](const hybrid::Options& options) {
    near = options.accuracy;
    return std::optional(0.5);
  };
  BOOST_TEST(impact::keep_promise({.accuracy = 1e-8}, {}, fails, shake) == 0.5);
  BOOST_TEST(near == 4e-8);
  BOOST_TEST(impact::keep_promise({.accuracy = 1e-8}, {}, fails, fails) == infinity);
}

BOOST_AUTO_TEST_CASE(what_is_too_long_to_run_again_has_no_bound) {
  const model::Chain box{.mass = {infinity, 1, 1.3, 0.7, 1.1, infinity},
                         .law = std::vector<contact::Law>(5, contact::Hertz{1e6}),
                         .gap = std::vector<double>(5, 0.1),
                         .velocity = {0, 1, 0, -0.5, 0.2, 0}};
  const hybrid::Options options{.max_time = 12000, .max_events = 1'000'000};
  const auto impact = impact::simulate(box, options);
  BOOST_TEST((impact.ending == hybrid::Ending::time_limit));
  BOOST_TEST(impact::passage(impact).periods > impact::most_periods_run_again);
  BOOST_TEST(impact.estimated_accuracy.value() == infinity);
  BOOST_TEST(impact::ChainSolver().solve(box, options).estimated_accuracy.value() == infinity);
}

BOOST_AUTO_TEST_CASE(what_is_no_result_has_no_error) {
  impact::BriefImpact run;
  run.ending = hybrid::Ending::separated;
  impact::set_estimate(infinity, run);
  BOOST_TEST(run.estimated_accuracy.value() == infinity);
  run.ending = hybrid::Ending::failed;
  impact::set_estimate(infinity, run);
  BOOST_TEST(!run.estimated_accuracy);
}

BOOST_AUTO_TEST_CASE(a_doubt_says_by_how_much) {
  BOOST_TEST(impact::doubt(6.4, 1e-10) ==
             "velocities may be wrong by 6.4e+00 of the largest speed, where 1e-10 was asked");
  BOOST_TEST(impact::doubt(infinity, 1e-10) == "nothing tells by how much velocities may be wrong");
  BOOST_TEST(impact::doubt(1e-10, 1e-10) == "");
  BOOST_TEST(impact::doubt({}, 1e-10) == "");
  BOOST_TEST(impact::tells_doubt(impact::doubt(infinity, 1) + "; a note"));
  BOOST_TEST(!impact::tells_doubt("max_time = 2 s was reached before the end"));
}

BOOST_AUTO_TEST_CASE(what_is_not_a_number_never_agrees) {
  const std::vector<double> right = {1, 2}, wrong = {std::numeric_limits<double>::quiet_NaN(), 2};
  BOOST_TEST(impact::difference(right, wrong, 1) == infinity);
  BOOST_TEST(impact::difference(wrong, right, 0) == infinity);
  BOOST_TEST(impact::difference(right, {{1, 2.5}}, 2) == 0.25);
}

BOOST_AUTO_TEST_CASE(a_run_that_balances_is_not_replaced_by_one_that_does_not) {
  using hybrid::Ending;
  BOOST_TEST(impact::may_replace(Ending::separated, Ending::separated));
  BOOST_TEST(impact::may_replace(Ending::unsure, Ending::separated));
  BOOST_TEST(impact::may_replace(Ending::unsure, Ending::unsure));
  BOOST_TEST(!impact::may_replace(Ending::separated, Ending::unsure));
  BOOST_TEST(!impact::may_replace(Ending::separated, Ending::interrupted));
  BOOST_TEST(!impact::may_replace(Ending::separated, Ending::failed));
  BOOST_TEST(impact::may_replace(Ending::event_limit, Ending::event_limit));
  BOOST_TEST(!impact::may_replace(Ending::separated, Ending::event_limit));
}

BOOST_AUTO_TEST_CASE(a_single_wave_is_run_once) {
  model::Chain chain{.mass = std::vector<double>(21, 1.0),
                     .law = std::vector<contact::Law>(20, contact::Hertz{1}),
                     .gap = std::vector<double>(20),
                     .velocity = std::vector<double>(21)};
  chain.velocity[0] = 1;
  BOOST_TEST(!impact::simulate(chain).estimated_accuracy);
  BOOST_TEST(!impact::ChainSolver().solve(chain).estimated_accuracy);
}

BOOST_AUTO_TEST_CASE(contacts_that_close_again_and_again_keep_the_accuracy) {
  int checked = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const auto chain = rattling(seed);
    const auto truth = impact::simulate(chain, {.accuracy = 1e-14});
    for (const double accuracy : {1e-7, 1e-10}) {
      const auto impact = impact::simulate(chain, {.accuracy = accuracy});
      if (!impact.estimated_accuracy || *impact.estimated_accuracy > accuracy) continue;
      ++checked;
      const double error = impact::difference(impact.velocity, truth.velocity, model::reference_speed(chain));
      BOOST_TEST(error <= accuracy, "seed " << seed << ": " << error << " at " << accuracy);
      const auto brief = impact::ChainSolver().solve(chain, {.accuracy = accuracy});
      BOOST_TEST(impact::difference(brief.velocity, impact.velocity, 0) < accuracy);
    }
  }
  BOOST_TEST(checked > 60);
}

// Tighter runs are the same to the last bit, and do not show it.
BOOST_AUTO_TEST_CASE(rounding_that_grows_beyond_the_accuracy_is_told) {
  const auto chain = light_between_heavy();
  const auto impact = impact::simulate(chain);
  BOOST_TEST_REQUIRE(impact.estimated_accuracy.has_value());
  BOOST_TEST(*impact.estimated_accuracy > 1e-6);
  impact::ChainSolver solver;
  const auto brief = solver.solve(chain);
  BOOST_TEST(brief.estimated_accuracy.value() == *impact.estimated_accuracy);
  BOOST_TEST(brief.velocity == impact.velocity, boost::test_tools::per_element());
  const auto network = model::as_network(chain);
  const auto linked = impact::simulate(network);
  BOOST_TEST(linked.estimated_accuracy.value() > 1e-6);
  BOOST_TEST(impact::NetworkSolver().solve(network).estimated_accuracy.value() == *linked.estimated_accuracy);
}

// The slowest motion is that of the heavy balls at the ends, 10⁶ times slower than that of light ones.
BOOST_AUTO_TEST_CASE(natural_modes_follow_what_series_would_take_millions_of_steps_for) {
  const auto impact = impact::ChainSolver().solve(light_between_heavy());
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_TEST(impact.steps < 10'000);
}

BOOST_AUTO_TEST_CASE(flights_count_before_contacts_that_push_together) {
  const auto longest = [](std::initializer_list<std::vector<impact::Period>> periods) {
    std::vector<impact::ContactHistory> contacts;
    for (const auto& list : periods) contacts.emplace_back().periods = list;
    return impact::longest_flight(contacts);
  };
  BOOST_TEST(longest({{{0, 1}, {101, 103}}, {{102, 105}}}) == 25);
  BOOST_TEST(longest({{{0, 1}, {101, 103}}, {{103, 105}}}) == 25);
  BOOST_TEST(longest({{{100, 103}}, {{102, 105}}}) == 0);  // what flies first flies as the scene says
  BOOST_TEST(longest({{{0, 1}, {101, 103}}, {{104, 105}}}) == 25);  // one soon after the other
  BOOST_TEST(longest({{{0, 1}, {101, 103}}, {{124, 125}}}) == 0);   // one long after the other
  BOOST_TEST(longest({{{0, 1}, {101, {}}}, {{102, {}}}}) == 0);     // not over
}

/// Balls that move together but for 10⁻⁵ of it: their meetings follow each other so soon, after flights so
/// long, that what is left out decides which of them push together.
BOOST_AUTO_TEST_CASE(contacts_that_close_soon_after_each_other_after_a_long_flight_keep_the_accuracy) {
  const model::Chain chain{
      .mass = {0.7535383156866058, 1.8027237834061336, 1.7919578119307444, 0.6262616281929276,
               1.8682114678310242, 0.6121233107265353, 1.6615098832586712, 0.9983727099307095},
      .law = std::vector<contact::Law>(7, contact::Hertz{1}),
      .gap = {6.56103547175004e-05, 2.1585593704354187e-07, 0.0001595426996351576, 0, 2.804941344891139e-05,
              1.5828328842138948, 0},
      .velocity = {0.9999999997594956, 0.999999211161163, 0.9999991894175889, 1.0267076023513824,
                   1.0267076009928469, 1.0267076010003204, 1.0267076009070146, 1.0265651029024925}};
  const auto truth = impact::simulate(chain, {.accuracy = 1e-12});
  const double speed = model::reference_speed(chain);
  for (const double accuracy : {1e-4, 1e-6, 1e-8}) {
    const auto brief = impact::ChainSolver().solve(chain, {.accuracy = accuracy});
    BOOST_TEST(impact::difference(brief.velocity, truth.velocity, speed) < accuracy);
    BOOST_TEST(brief.estimated_accuracy.has_value());
  }
}

BOOST_AUTO_TEST_CASE(balls_that_creep_while_another_one_flies_keep_the_accuracy) {
  const auto chain = creeping_balls();
  const auto truth = impact::simulate(chain, {.accuracy = 1e-12}).velocity;
  expect_accuracy<impact::ChainSolver>(chain, truth);
  expect_accuracy<impact::NetworkSolver>(model::as_network(chain), truth);
}

/// A light ball closes one contact four times, where all others close once or twice.
BOOST_AUTO_TEST_CASE(a_ball_that_rattles_among_others_keeps_the_accuracy) {
  const model::Chain chain{.mass = {8.968587104322598, 1.0779744298543756, 0.04132843107153663,
                                    0.10688237400499383, 0.08653158149174978},
                           .law = {contact::Hertz{2.4790458078306545}, contact::Hertz{8.797710026875862},
                                   contact::Hertz{0.089047994353279}, contact::Hertz{0.0011468428950601986}},
                           .gap = std::vector<double>(4, 0.0),
                           .velocity = {1, 0, 0, 0, -0.001}};
  const auto truth = impact::simulate(chain, {.accuracy = 1e-12});
  for (const double accuracy : {1e-4, 1e-7, 3e-8}) {
    const auto impact = impact::simulate(chain, {.accuracy = accuracy});
    BOOST_TEST(impact::difference(impact.velocity, truth.velocity, 1) < accuracy);
    BOOST_TEST(impact.estimated_accuracy.has_value());
  }
}

/// Two balls part by creeping, and fly for 10⁵ times as long as they pushed before a third one comes: the
/// error of their parting decides how far apart they are then.
BOOST_AUTO_TEST_CASE(contacts_that_close_together_after_a_long_flight_keep_the_accuracy) {
  const model::Chain chain{
      .mass = {0.23345304199960015, 0.25926534687407493, 1.1166483335231239},
      .law = {contact::Hertz{1}, contact::Viscoelastic{.stiffness = 1, .damping = 5031.8710299833601}},
      .gap = {0.18100941894992018, 0},
      .velocity = {0, -2.3890898e-07, -2.4945841e-07}};
  const auto truth = impact::simulate(chain, {.accuracy = 1e-14});
  const auto impact = impact::simulate(chain, {.accuracy = 1e-10});
  const double speed = model::reference_speed(chain);
  BOOST_TEST(impact::difference(impact.velocity, truth.velocity, speed) < 1e-10);
  BOOST_TEST(impact.estimated_accuracy.value() <= 1e-10);
  const auto brief = impact::ChainSolver().solve(chain, {.accuracy = 1e-10});
  BOOST_TEST(impact::difference(brief.velocity, truth.velocity, speed) < 1e-10);
}

/// Two balls part too slowly to tell, and fly for 53 times as long as a third one pushes them later: how far
/// apart they are then is ten times the length of the flight of what may be left out. The last ball flies
/// away: what meets does so 700 times slower. The truth is told by somebody who flies along with the others.
BOOST_AUTO_TEST_CASE(a_flight_of_ten_durations_is_long) {
  const auto damped = [](double stiffness, double damping, double exponent) {
    return contact::PowerLaw{stiffness, damping, exponent};
  };
  const model::Chain chain{.mass = {1, 1, 1, 1, 1},
                           .law = {damped(2.6466358948876487, 0.0068372098390351438, 1.1612418601502654),
                                   damped(0.54842776230433077, 0.0040850303018798674, 2.2151364094083816),
                                   damped(2.0899927085986221, 76.981438569023908, 1),
                                   damped(0.13824934099424246, 0.04376690737643274, 2.8466084340497191)},
                           .gap = {0, 0.86762835436484864, 0.16353968981074041, 0.12333498142638522},
                           .velocity = {-0.13347465137237591, -0.13347465137280537, -0.13366329959560605,
                                        -0.13366329959539328, 0.021936714161810533}};
  constexpr double flown = -0.1336;
  const auto seen = [](std::vector<double> velocity) {
    for (double& v : velocity) v -= flown;  // exact
    return velocity;
  };
  auto along = chain;
  along.velocity = seen(chain.velocity);
  const auto truth = impact::simulate(along, {.accuracy = 1e-13});
  for (const double accuracy : {1e-8, 1e-9, 1e-10})
    BOOST_TEST(impact::difference(seen(impact::simulate(chain, {.accuracy = accuracy}).velocity),
                                  truth.velocity, model::reference_speed(chain)) < accuracy);
}

/// Balls of one velocity but for 10⁻⁷ to 10⁻¹³ of it fly for 10⁶ times as long as they push: what a run of
/// this accuracy and one a little tighter leave out alike is as large as what moves them.
BOOST_AUTO_TEST_CASE(a_long_flight_asks_for_a_run_that_is_tighter_by_its_length) {
  const model::Chain chain{
      .mass = std::vector<double>(6, 0.0042922324062076665),
      .law = {contact::Linear{1.6470003210017384e-12}, contact::Linear{9.6507580277016538e-14},
              contact::Linear{7.1508081628115035e-14}, contact::Linear{4.4889380079650702e-13},
              contact::Linear{5.613657982808551e-13}},
      .gap = {0, 0.0016073799906054741, 0.047353136751362421, 0, 0},
      .velocity = {2.6599641946932958e-07, 2.6599641937797274e-07, 2.6599630778747411e-07,
                   2.6599630769564971e-07, 2.6599630769560376e-07, 3.6679959749113389e-07}};
  const auto truth = impact::simulate(chain, {.accuracy = 1e-14});
  for (const double accuracy : {1e-8, 1e-9})
    BOOST_TEST(impact::difference(impact::simulate(chain, {.accuracy = accuracy}).velocity, truth.velocity,
                                  model::reference_speed(chain)) < accuracy);
}
