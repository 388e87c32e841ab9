#define BOOST_TEST_MODULE stiff damping
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "support/reference.hpp"

using namespace mariotte;

namespace {

contact::Law law(double stiffness, double damping, double exponent) {
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = exponent};
}

/// Balls and Hertz-like dampers of c = 10 to 10^`most`; many contacts creep, pressed by their neighbours.
model::Chain random_chain(std::mt19937_64& random, double most) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto decades = [&](double low, double high) {
    return std::pow(10, low + (high - low) * unit(random));
  };
  model::Chain chain;
  const int balls = std::uniform_int_distribution(2, 4)(random);
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(decades(-1, 1));
    chain.velocity.push_back(i == 0 ? 1 : -unit(random) * (unit(random) < 0.5));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(unit(random) < 0.7 ? 0 : 0.01 * unit(random));
    chain.law.push_back(
        contact::Viscoelastic{.stiffness = decades(-1, 1), .damping = decades(1, most), .exponent = 1.5});
  }
  return chain;
}

/// Compares random chains of c = 10 to 10^`most_damping` with BDF; returns the most steps of one. Up to c =
/// 10⁴ BDF knows loads so well that numbers of periods are the same; beyond, it has ghosts.
Index check_creeping(unsigned seed, int scenes, double most_damping) {
  std::mt19937_64 random(seed);
  impact::ChainSolver solver;
  Index most_steps = 0;
  for (int i = 0; i < scenes; ++i) {
    const auto chain = random_chain(random, most_damping);
    const auto own = solver.solve(chain, {.accuracy = 1e-8});
    const auto exact = solver.solve(chain, {.accuracy = 1e-11, .flow = flow::Kind::cvode_bdf_klu});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST((own.ending == hybrid::Ending::separated));
      BOOST_TEST(test::difference(own.velocity, exact.velocity) < 1e-8);
      if (most_damping <= 4) BOOST_TEST(own.periods == exact.periods, boost::test_tools::per_element());
    }
    most_steps = std::max(most_steps, own.steps);
  }
  return most_steps;
}

}  // namespace

// The load of a creeping contact is a small difference of large terms: told with too few digits its sign
// makes ghost periods, and explicit steps would last for ever.
BOOST_AUTO_TEST_CASE(creeping_contacts_make_no_ghost_events_and_come_to_an_end) {
  BOOST_TEST(check_creeping(7, 80, 4) < 50'000);
}

// There the load is rounding from the start; where nothing creeps for long BDF takes 700 times as long.
BOOST_AUTO_TEST_CASE(series_follow_dampers_however_strong) {
  BOOST_TEST(check_creeping(8, 40, 8) < 50'000);
  const model::Chain triplet{
      .mass = {1, 1, 1}, .law = {law(1, 1e6, 1.5), law(1, 1e6, 1.5)}, .gap = {0, 0}, .velocity = {1, 0, 0}};
  BOOST_TEST(impact::ChainSolver().solve(triplet).steps < 200);
}

// A load that has vanished but for rounding when its contact becomes slack may stand above zero already.
// A contact creeps apart by itself, its load but rounding, when the ball behind it is struck: gently at
// first.
// Two slow balls between fast ones: what is rounding of the fast ones is none of theirs.
BOOST_AUTO_TEST_CASE(slow_balls_among_fast_ones_close_and_open_a_few_times) {
  const std::vector<contact::Law> half = {
      contact::Viscoelastic{
          .stiffness = 404.26751224197528, .damping = 0.051762067112120475, .exponent = 1.6484198088926214},
      contact::Viscoelastic{.stiffness = 4.7446296344718881, .damping = 0, .exponent = 2},
      contact::Viscoelastic{
          .stiffness = 1.5324059912037331e-05, .damping = 2.4677633278642192e-08, .exponent = 3},
      contact::Viscoelastic{.stiffness = 0.00060654201433523456,
                            .damping = 0.043443157714494897,
                            .exponent = 2.7090626569376974}};
  model::Chain chain{
      .mass = {34.018686418929484, 6.1220185821179394, 12.233869746456932, 11.400613920154244,
               705.18962325216592, 11.400613920154244, 12.233869746456932, 6.1220185821179394,
               34.018686418929484},
      .law = half,
      .gap = {0, 210668.6645034141, 196417.42754450851, 294168.9939699081, 294168.9939699081,
              196417.42754450851, 210668.6645034141, 0},
      .velocity = {23462941.317596033, 14515987.323729215, -18007288.059202071, 22445550.75360848, 0,
                   -22445550.75360848, 18007288.059202071, -14515987.323729215, -23462941.317596033}};
  chain.law.insert(chain.law.end(), half.rbegin(), half.rend());
  impact::ChainSolver solver;
  for (const double accuracy : {1e-8, 1e-10, 1e-12}) {
    const auto& impact = solver.solve(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(impact.events < 100);
  }
}

// Contacts that creep are pressed gently: at first their loads are smaller than rounding makes them.
// The closed form of a pair starts with a load that rounding has made negative.
BOOST_AUTO_TEST_CASE(damping_beyond_double_precision_is_refused) {
  for (const double damping : {1e14, 1e50, 1e100, 1e280})
    for (const double exponent : {1.0, 1.5}) {
      const contact::Law law =
          contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = exponent};
      const model::Chain chain{.mass = {1, 1, 1}, .law = {law, law}, .gap = {0, 0}, .velocity = {1, 0, 0}};
      BOOST_CHECK_THROW(impact::ChainSolver().solve(chain), InvalidParameter);
    }
}

BOOST_AUTO_TEST_CASE(the_strongest_damping_that_is_computed_stops_balls_together) {
  for (const double damping : {1e6, 1e8, 1e10, 5e11}) {
    const contact::Law law = contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = 1};
    const model::Chain chain{.mass = {1, 1, 1}, .law = {law, law}, .gap = {0, 0}, .velocity = {1, 0, 0}};
    const auto impact = impact::ChainSolver().solve(chain);
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(test::difference(impact.velocity, {1.0 / 3, 1.0 / 3, 1.0 / 3}) < 1e-9);
  }
}

// All that the first pair does is below the accuracy: it lets go well above where it would close again.
// A ball of 0.01 rattles 3500 times between heavy ones while a damper creeps. BDF would take a hundred steps
// each time, series three: they go on.
BOOST_AUTO_TEST_CASE(what_rattles_beside_a_creeping_damper_stays_with_series) {
  const model::Chain chain{.mass = {24812.641456324927, 0.010463545199853212, 1448.5690932301716,
                                    57.711662327016668, 70.302378542774548},
                           .law = {law(0.00010700576034470817, 2.4272059348559763e-06, 1.1174548642958955),
                                   law(0.086776375135265524, 0, 1.3297293458487336),
                                   law(0.00017609856877118338, 0.0022763204154275809, 1.7606216572168762),
                                   law(2.8717213007202269, 0.46462178516388403, 3)},
                           .gap = {0.21205815546305007, 0, 3.3854757569142216e-08, 3.8377334248590293e-06},
                           .velocity = {1, 0, 0, 0, 0}};
  const std::vector<double> expected = {0.8805159855166, 1.8723509669694, 1.8786626459632, 1.9005432199910,
                                        1.9009067457253};
  for (const double accuracy : {1e-6, 1e-9}) {
    const auto impact = impact::ChainSolver().solve(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(test::difference(impact.velocity, expected) < accuracy);
    BOOST_TEST(impact.steps < 60'000);
  }
}

// Contact 2 lets go with a load of rounding, above zero as well as below. What strikes its ball begins
// gently.
// A contact that creeps like exp(−k t/c) has a load smaller than its rounding. Whether it still pushes must
// not depend on whether that crosses zero.
// Its load vanishes within a twentieth of its natural time; it would creep for 10⁵ of them.
// Of a contact that has hardly begun, coefficients of order 20 are as large as (δ̇/δ)²⁰ with δ = 10⁻¹⁷.
BOOST_AUTO_TEST_CASE(series_of_a_contact_that_has_hardly_begun_do_not_overflow) {
  const model::Chain chain{
      .mass = {0.7761538174417637, 0.90334308846299383, 1.6130654382674201, 1.0653062242311309},
      .law = {law(1, 0.31137376435825925, 3), law(1, 856.17378097676612, 1.1229864242378411),
              law(1, 0.049225910881886187, 1.5944080574212465)},
      .gap = {0, 0, 0},
      .velocity = {0.76801022962017962, 0.24409180884597825, 0.32658001912564183, -0.75254404977730682},
      .gravity = -0.60848021854188694};
  impact::ChainSolver solver;
  for (const double accuracy : {1e-10, 1e-13, 1e-15}) {
    const auto& impact = solver.solve(chain, {.accuracy = accuracy, .max_events = 100});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(impact.periods == (std::vector<Index>{1, 1, 1}), boost::test_tools::per_element());
  }
}

// The load by which the second ball holds the light one is smaller than what a loose step makes of it.
BOOST_AUTO_TEST_CASE(a_light_ball_that_is_pressed_gently_stays_where_it_is_at_loose_accuracy) {
  const model::Chain chain{.mass = {0.00037966677690409972, 16.637117187372333, 132.59030537892272},
                           .law = {law(12.975591817359314, 93.768260694455705, 1),
                                   law(1113.0219139862654, 1.7103913486935007, 1.5)},
                           .gap = {0, 0},
                           .velocity = {1, 0, 0}};
  impact::ChainSolver solver;
  const auto exact = solver.solve(chain, {.accuracy = 1e-10});
  const auto loose = solver.solve(chain, {.accuracy = 1e-6, .max_events = 100});
  BOOST_TEST((loose.ending == hybrid::Ending::separated), loose.message);
  BOOST_TEST(loose.periods[0] <= exact.periods[0]);
  BOOST_TEST(test::difference(loose.velocity, exact.velocity) < 1e-6);
}

// Two light balls with a strong damper between them swing on a heavy one. BDF's first steps are no longer
// than those of series, which would need more than ten million of them; its later ones are.
BOOST_AUTO_TEST_CASE(series_lose_patience_with_a_damper_that_swings) {
  const model::Chain chain{.mass = {1671.5133400401337, 1931.7199056826878, 0.0058671970811175244,
                                    0.0043374688689555626, 1934.9315210821615},
                           .law = {law(0.12595767632776911, 0, 1.2450208712448474),
                                   law(0.0010990372726720763, 0.0017268427067702453, 1.6858878094517205),
                                   law(1.301907658342075, 760.90032168294522, 1.3180390311303654),
                                   law(375.54281429107579, 0.053539772941115706, 1.4507332755405389)},
                           .gap = {0, 0, 0, 0.83143977943791547},
                           .velocity = {0.17375322969634488, 0.70501693444886171, 0.83082167575411581,
                                        -0.34190805197290408, 0.093203598533756038}};
  const std::vector<double> expected = {0.0927381923, 0.1682967853, 0.6970125789, 0.6988083862, 0.6990167604};
  const auto impact = impact::ChainSolver().solve(chain, {.accuracy = 1e-8});
  BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
  BOOST_TEST(test::difference(impact.velocity, expected) < 1e-9);
  BOOST_TEST(impact.steps < 1'000'000);
}

// One damper makes many phases too stiff for series. The first of them takes 5000 of their steps before BDF
// goes on; the others are left earlier.
BOOST_AUTO_TEST_CASE(a_run_learns_when_to_leave_a_phase_to_bdf) {
  model::Chain chain{.mass = {0.889, 0.877, 1.058, 0.729, 1.154, 0.924, 1.041, 1.35},
                     .law = {law(1, 0, 1), law(1, 0, 1), law(1, 3.2e5, 1), law(1, 0, 1), law(1, 0, 1),
                             law(1, 0, 1.5), law(1, 0.0123, 1)},
                     .gap = std::vector<double>(7),
                     .velocity = std::vector<double>(8)};
  chain.velocity[0] = 1;
  const auto impact = impact::simulate(chain, {.accuracy = 1e-8});
  const auto steps = [&](std::string_view name) {
    for (const auto& use : impact.flows)
      if (use.name == name) return use;
    return impact::FlowUse{};
  };
  const auto bdf = steps("cvode-bdf-klu");
  BOOST_TEST(bdf.phases >= 5);
  BOOST_TEST(steps("taylor").steps < 5000 + 11 * bdf.steps);
  BOOST_TEST(steps("taylor").steps < 0.8 * 5000 * static_cast<double>(bdf.phases));
}
