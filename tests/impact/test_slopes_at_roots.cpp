// Slopes through the roots of forces: where contacts of any exponent and damping begin, and where they end.
#define BOOST_TEST_MODULE slopes_at_roots
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/named_laws.hpp"
#include "mariotte/contact/thornton_ning.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

using namespace mariotte;
using contact::Law;

namespace {

model::Chain three_balls(const Law& first, const Law& second, double gap) {
  return {.mass = {1, 1.3, 0.8}, .law = {first, second}, .gap = {gap, 0.2}, .velocity = {1, 0.1, -0.2}};
}

/// Differences of order four of the final velocities.
std::vector<double> differences(const impact::Parameter<model::Chain>& by, double h) {
  impact::ChainSolver solver;
  std::vector<double> at[5];
  for (const int k : {-2, -1, 1, 2})
    at[k + 2] = solver.solve(by.model(by.value + k * h), {.accuracy = 1e-14}).velocity;
  std::vector<double> slopes;
  for (std::size_t i = 0; i < at[0].size(); ++i)
    slopes.push_back(((at[0][i] - at[4][i]) + 8 * (at[3][i] - at[1][i])) / (12 * h));
  return slopes;
}

void expect_slopes_of_differences(const model::Chain& chain) {
  const auto by = impact::parameters(chain);
  const auto found = impact::sensitivity(chain, by, {.accuracy = 1e-8});
  for (std::size_t c = 0; c < by.size(); ++c) {
    if (by[c].value == 0) continue;  // a gap of zero has one side
    const auto expected = differences(by[c], 2e-4);
    for (std::size_t i = 0; i < expected.size(); ++i)
      BOOST_TEST(std::abs(found.outcome[i].slope[c].value() - expected[i]) <= 3e-8,
                 "velocity " << i << " by " << by[c].name << ": " << found.outcome[i].slope[c].value()
                             << ", differences " << expected[i]);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(dampers_of_all_exponents_begin_with_slopes) {
  for (const double exponent : {1.02, 1.1, 1.3, 1.7})
    for (const double gap : {0.0, 0.3}) BOOST_TEST_CONTEXT("exponent " << exponent << ", gap " << gap) {
        const Law law = contact::Viscoelastic{3, 0.4, exponent};
        expect_slopes_of_differences(three_balls(law, contact::Viscoelastic{2, 0.3, exponent}, gap));
      }
}

BOOST_AUTO_TEST_CASE(dampers_that_pull_until_the_end_have_slopes) {
  const auto tsuji = std::make_shared<contact::Tsuji>(3, 0.4);
  expect_slopes_of_differences(three_balls(contact::uncut(tsuji), contact::Hertz{2}, 0.3));
  expect_slopes_of_differences(three_balls(contact::Linear{2}, contact::uncut(tsuji), 0.3));
}

// What is left of the last step, which ends where the contact lets go, is rounding. The slope is that of
// differences of runs at 10⁻¹³.
BOOST_AUTO_TEST_CASE(adhesive_contacts_let_go_with_slopes_that_know_their_rounding) {
  const model::Chain chain{
      .mass = {1.7065844666709014, 4.8733644386278758, 0.10405966342818254},
      .law = {std::make_shared<contact::HuntCrossley>(0.68622324929616807, 0.12862655040552784, 1),
              contact::state(contact::Jkr(1.190354621122178, 2.9768854219596772, 0.0020725517418666863, 0))},
      .gap = {0.23074191400143368, 0.31289019781636562},
      .velocity = {0.4072947391404742, 0.16012354139283125, -0.45081640803452694}};
  auto by = impact::parameters(chain);
  std::erase_if(by, [](const auto& one) { return one.name != "velocity[0]"; });
  const auto found = impact::sensitivity(chain, by, {.accuracy = 1e-10});
  BOOST_TEST(std::abs(found.outcome[2].slope[0].value() - 0.0326083918045) < 5e-10);
}

// Force and indentation of a dented contact have a fold where it lets go, with a slope without bound: what a
// dent rounds there must not count as indentation.
BOOST_AUTO_TEST_CASE(dented_adhesive_contacts_let_go_with_slopes_that_hardly_move) {
  const auto slope_at = [](double pressure) {
    const contact::ThorntonNing law(0.44908054460201613, 0.58909261727350071, pressure, 0.022853974783125383);
    const model::Chain chain{.mass = {0.5374474078868714, 1.1858953039840856},
                             .law = {contact::state(law)},
                             .gap = {0.17342769965795668},
                             .velocity = {-0.20641173529486445, -0.95871265506153258}};
    auto by = impact::parameters(chain);
    by.resize(1);
    return impact::sensitivity(chain, by, {.accuracy = 1e-10}).outcome[0].slope[0].value();
  };
  const double pressure = 0.22857234034107271, middle = slope_at(pressure);
  for (const double share : {-1e-9, -1e-11, -1e-13, 1e-13, 1e-11, 1e-9})
    BOOST_TEST(std::abs(slope_at(pressure * (1 + share)) - middle) < 1e-9);
}

// It springs back a million times as hard as it is pressed: v⁺ = −√(k₁/k₂) v.
BOOST_AUTO_TEST_CASE(contacts_that_unload_steeply_have_slopes) {
  const double loading = 1e3, unloading = 1e9;
  const model::Chain pair{.mass = {1, infinity},
                          .law = {contact::state(contact::WaltonBraun(loading, unloading))},
                          .gap = {1},
                          .velocity = {1, 0}};
  auto by = impact::parameters(pair);
  std::erase_if(by, [](const auto& one) { return !one.name.ends_with("loading_stiffness"); });
  BOOST_TEST_REQUIRE(by.size() == 2u);
  const auto slope = impact::sensitivity(pair, by, {.accuracy = 1e-10}).outcome[0].slope;
  const double half = 0.5 * std::sqrt(loading / unloading);
  BOOST_TEST(std::abs(slope[0].value() * loading / -half - 1) < 1e-7);
  BOOST_TEST(std::abs(slope[1].value() * unloading / half - 1) < 1e-6);
}

// By the exponent of an outer contact everything loses its symmetry, and slopes are large for long; by that
// of the middle one they turn where dampers begin. A piece is as short as each of them needs.
BOOST_AUTO_TEST_CASE(slopes_by_one_number_do_not_depend_on_what_else_is_asked) {
  const contact::Viscoelastic outer{566208.97828474699, 6300.4258875649812, 3};
  const model::Chain chain{
      .mass = {6.8036588326924528e-05, 6.6753434152064603e-05, 6.6753434152064603e-05,
               6.8036588326924528e-05},
      .law = {outer, contact::Viscoelastic{2183.7044577873489, 6.3585153960040994, 2}, outer},
      .gap = {2.6142786375869227e-06, 0, 2.6142786375869227e-06},
      .velocity = {7.0052622528693145e-05, 0.00010769596180580733, -0.00010769596180580733,
                   -7.0052622528693145e-05}};
  auto by = impact::parameters(chain);
  std::erase_if(by, [](const auto& one) { return !one.name.ends_with("exponent"); });
  for (const double accuracy : {1e-8, 1e-10}) {
    const auto together = impact::sensitivity(chain, by, {.accuracy = accuracy});
    const auto alone = impact::sensitivity(chain, {by[1]}, {.accuracy = accuracy});
    for (std::size_t i = 0; i < chain.velocity.size(); ++i) {
      const double expected = alone.outcome[i].slope[0].value();
      BOOST_TEST(std::abs(together.outcome[i].slope[1].value() / expected - 1) < 3 * accuracy);
    }
  }
}

// Two dampers begin at one instant, and a mass draws them apart. The second begins by the clock of the first:
// its force c δ^q δ̇ with a small q is there at depths that no piece resolves, and a note says what that may
// cost.
BOOST_AUTO_TEST_CASE(steep_dampers_that_begin_together_say_what_is_not_resolved) {
  const auto row = [](double exponent) {
    const contact::Law steep = contact::Viscoelastic{.stiffness = 1, .damping = 0.5, .exponent = exponent};
    return model::Chain{.mass = {1, 1, 1, 1, 1},
                        .law = {steep, contact::Hertz{1}, contact::Hertz{1}, steep},
                        .gap = {0.1, 0.5, 0.5, 0.1},
                        .velocity = {1, 0, 0, 0, -1}};
  };
  const auto error = [&](double exponent) {
    double largest = 0;
    for (const auto& note : impact::sensitivity(row(exponent), impact::parameters(row(exponent))).notes)
      if (note.text.find("contact 1") != std::string::npos && std::isfinite(note.error))
        largest = std::max(largest, note.error);
    return largest;
  };
  BOOST_TEST(error(1.01) > 0.5);
  BOOST_TEST(error(1.5) == 0);
}
