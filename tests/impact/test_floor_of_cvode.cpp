// What steps of CVODE leave, whatever its tolerance, is in the estimate.
#define BOOST_TEST_MODULE impact_floor_of_cvode
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>

#include "mariotte/contact/dmt.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/promise.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

using namespace mariotte;

/// Two balls that adhere ring 66 times beside a ball that creeps into a damped wall. All runs have the same
/// steps of BDF, and agree in their errors. The pair alone is followed in closed form and by series.
BOOST_AUTO_TEST_CASE(rows_that_ring_for_long_say_what_steps_of_cvode_leave) {
  const contact::Law bond =
      contact::state(contact::Jkr(0.0221554926035175, 18.87033961665781, 0.00010189213356937681, 0));
  const model::Chain pair{.mass = {0.00019667420298899145, 2.5725081437200994},
                          .law = {bond},
                          .gap = {0},
                          .velocity = {0.8081561391748562, 0}};
  const hybrid::Options options{.accuracy = 1e-10, .max_time = 10.787224654586286};
  const auto truth = impact::simulate(pair, options);
  model::Chain row = pair;
  row.mass.insert(row.mass.begin(), {infinity, 0.44882497092305407});
  row.velocity.insert(row.velocity.begin(), {0, -0.27463670197610757});
  row.gap.insert(row.gap.begin(), {0.00018530584109851807, 0.0044508061083701955});
  row.law.insert(row.law.begin(),
                 {contact::state(contact::Dmt(0.9596983823899914, 172.94023295121517, 0.00041259874475712877,
                                              11.542484773618687)),
                  contact::state(contact::Dmt(0.01909991439495466, 58.49728478594662, 0.00033718852065985755,
                                              0.006653474851786529))});
  const auto impact = impact::simulate(row, options);
  const double error = std::abs(impact.velocity[2] - truth.velocity[0]);
  BOOST_TEST_REQUIRE(impact.estimated_accuracy.has_value());
  BOOST_TEST(error < *impact.estimated_accuracy * model::reference_speed(row));
}

/// One contact that adheres is followed by BDF, with the same steps at each of these accuracies.
BOOST_AUTO_TEST_CASE(steps_of_cvode_in_a_single_wave_leave_some_error) {
  const model::Chain row{
      .mass = {0.03, 0.05078687884882144, 0.03, 0.006928703655343225, 0.03, infinity},
      .law = {contact::Hertz{556654098.0639822}, contact::Linear{9071283.092203328},
              std::make_shared<contact::Tsuji>(134867362.5200464, 945.8293048269235),
              contact::state(contact::Dmt(1653673879.4373157, 0.005, 16.971779545230163, 0)),
              contact::Linear{38622430.71324064}},
      .gap = {0, 0, 0, 8.644609020983613e-06, 3.296925354206567e-06},
      .velocity = {1.0686214631314788, 0, 0, 0, -0.21599932718017512, 0}};
  const double end = 0.002145050437939878;
  for (const double accuracy : {1e-12, 1e-13}) {
    const auto impact = impact::simulate(row, {.accuracy = accuracy, .max_time = end});
    const auto adams =
        impact::simulate(row, {.accuracy = accuracy, .max_time = end, .flow = flow::Kind::cvode_adams});
    const double apart = impact::difference(impact.velocity, adams.velocity, model::reference_speed(row));
    BOOST_TEST_MESSAGE(apart << " " << impact.estimated_accuracy.value_or(0));
    BOOST_TEST(apart < impact.estimated_accuracy.value_or(accuracy));
  }
}

BOOST_AUTO_TEST_CASE(steps_of_cvode_in_a_single_wave_do_not_add_up) {
  for (const int balls : {3, 21}) {
    model::Chain row{.mass = std::vector(balls, 1.0),
                     .law = std::vector<contact::Law>(balls - 1, contact::Hertz{1}),
                     .gap = std::vector(balls - 1, 0.0),
                     .velocity = std::vector(balls, 0.0)};
    row.velocity[0] = 1;
    const auto truth = impact::simulate(row, {.accuracy = 1e-13}).velocity;
    for (const auto flow : {flow::Kind::cvode_adams, flow::Kind::cvode_bdf_klu}) {
      const auto impact = impact::simulate(row, {.accuracy = 1e-10, .flow = flow});
      BOOST_TEST(impact.estimated_accuracy.value_or(0) <= 1e-10);
      BOOST_TEST(impact::difference(impact.velocity, truth, 1) < 1e-10);
    }
  }
}
