// Pairs against the closed form of the restitution, and against numbers computed in extended precision.
#define BOOST_TEST_MODULE Hunt and Crossley
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"

using namespace mariotte;

namespace {

struct Pair {
  double left, right;                   ///< masses [kg]
  double speed;                         ///< approach [m/s]
  double stiffness, damping, exponent;  ///< k, a, n in SI units
  double restitution;                   ///< solution of the closed form, by 30 digits of mpmath
  double time;                          ///< of separation [s], by integration in extended precision
};

const Pair pairs[] = {{0.031, 0.05, 0.05, 9.5e9, 2, 1.5, 0.93747557994990507, 1.2371434254190418e-4},
                      {0.031, 0.05, 1, 9.5e9, 2, 1.5, 0.41071968606103943, 7.9281283983567238e-5},
                      {infinity, 0.02, 0.3, 2e6, 1.667, 1, 0.7483967292819893, 3.1663981453435603e-4},
                      {infinity, 0.02, 4, 4e12, 3, 2.3, 0.083330884571186262, 2.4009156914508143e-4}};

impact::ChainImpact simulated(const Pair& pair) {
  const bool wall = std::isinf(pair.left);
  return impact::simulate(
      {.mass = {pair.left, pair.right},
       .law = {std::make_shared<contact::HuntCrossley>(pair.stiffness, pair.damping, pair.exponent)},
       .gap = {0},
       .velocity = {wall ? 0 : pair.speed, wall ? -pair.speed : 0}},
      {.accuracy = 1e-11});
}

}  // namespace

// Accuracy 1e-11 of the incident speed; e is a ratio of a difference to that speed.
BOOST_AUTO_TEST_CASE(restitution_and_duration_are_those_of_the_closed_form) {
  for (const auto& pair : pairs) {
    const auto impact = simulated(pair);
    const double e = (impact.velocity[1] - impact.velocity[0]) / pair.speed;
    BOOST_TEST(std::abs(e - pair.restitution) < 1e-9);
    BOOST_TEST(std::abs(impact.time / pair.time - 1) < 1e-8);
    BOOST_TEST(impact.flows.at(0).name == "taylor");
    const double mass = 1 / (1 / pair.left + 1 / pair.right);
    BOOST_TEST(std::abs(impact.energy.dissipated / (0.5 * mass * pair.speed * pair.speed * (1 - e * e)) - 1) <
               1e-8);
  }
}

// Struck from both sides.
BOOST_AUTO_TEST_CASE(rows_of_any_dampers_are_those_that_cvode_follows) {
  const auto grown = [](double n) { return std::make_shared<contact::HuntCrossley>(1, 0.7, n); };
  const auto even = std::make_shared<contact::Tsuji>(1, 0.4);
  const contact::Viscoelastic lossy{.stiffness = 1, .damping = 0.3, .exponent = 1.25};
  const std::vector<std::vector<contact::Law>> rows = {
      {grown(1), grown(1), grown(1)},          {grown(1.5), contact::Hertz{2}, grown(1)},
      {grown(1.3), lossy, contact::Linear{1}}, {even, even, even},
      {contact::Hertz{1}, even, lossy},        {even, grown(1.5), contact::Linear{3}}};
  for (const auto& law : rows) {
    const model::Chain chain{
        .mass = {1, 0.1, 1, 0.3}, .law = law, .gap = {0, 0.02, 0}, .velocity = {1, 0.2, 0, -2}};
    const auto series = impact::simulate(chain, {.accuracy = 1e-11});
    const auto steps = impact::simulate(chain, {.accuracy = 1e-12, .flow = flow::Kind::cvode_adams});
    for (const auto& flow : series.flows) BOOST_TEST(!flow.name.starts_with("cvode"));
    BOOST_TEST(series.events.size() == steps.events.size());
    for (std::size_t i = 0; i < chain.mass.size(); ++i)
      BOOST_TEST(std::abs(series.velocity[i] - steps.velocity[i]) < 1e-10);
    BOOST_TEST(std::abs(series.energy.residual) < 1e-10);
  }
}

// While a soft contact turns the ball in the middle, the other, slack, is pressed again before it opens: its
// load is a power of a depth that nobody else feels.
BOOST_AUTO_TEST_CASE(a_slack_contact_is_pressed_again_when_its_load_says_so) {
  const model::Chain chain{.mass = {1.28, 2.52, 2.51},
                           .law = {contact::Viscoelastic{.stiffness = 0.127, .damping = 0.009, .exponent = 1},
                                   std::make_shared<contact::Tsuji>(1.286, 0.58)},
                           .gap = {0.0134, 0.214},
                           .velocity = {0.929, 0.26, -0.328}};
  const auto steps =
      impact::simulate(chain, {.accuracy = 1e-13, .max_time = 6, .flow = flow::Kind::cvode_adams});
  for (const double accuracy : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto series = impact::simulate(chain, {.accuracy = accuracy, .max_time = 6});
    BOOST_TEST(series.events.size() == steps.events.size());
    for (std::size_t i = 0; i < chain.mass.size(); ++i)
      BOOST_TEST(std::abs(series.velocity[i] - steps.velocity[i]) < std::max(accuracy, 3e-12));
  }
}

// Where a v e is near 1 the logarithm magnifies the last digit of e 4·10⁵ times.
BOOST_AUTO_TEST_CASE(the_restitutions_solve_the_closed_form) {
  for (const auto& pair : pairs) {
    const double e = pair.restitution, av = pair.damping * pair.speed;
    BOOST_TEST(std::abs(av * (1 + e) - std::log((1 + av) / (1 - av * e))) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(a_pair_lets_go_where_the_gap_opens) {
  const auto impact = simulated(pairs[1]);
  BOOST_TEST(std::abs(impact.gap[0]) < 1e-10 * impact.contacts[0].peak_indentation);
}

// 1 + a δ̇ fades to less than rounding long before the gap opens. Times by quadrature of the closed form
// k δ²/2 = m ((v − w)/a − ln((1 + a v)/(1 + a w))/a²).
BOOST_AUTO_TEST_CASE(a_load_that_has_faded_lets_nothing_go) {
  for (const auto& [damping, time] :
       {std::pair{40.0, 0.206016887027}, {100, 0.320013443839}, {300, 0.549903338047}})
    for (const double accuracy : {1e-6, 1e-10, 1e-12, 1e-13})
      for (const auto flow : {std::optional<flow::Kind>(), std::optional(flow::Kind::cvode_adams)}) {
        const auto impact =
            impact::simulate({.mass = {1, 1},
                              .law = {std::make_shared<contact::HuntCrossley>(1000, damping, 1)},
                              .gap = {0},
                              .velocity = {1, 0}},
                             {.accuracy = accuracy, .flow = flow});
        BOOST_TEST(impact.time == time, boost::test_tools::tolerance(1e-7));
      }
}

// It is deepest at the start, where it has no force.
BOOST_AUTO_TEST_CASE(a_contact_that_is_slack_from_the_start_has_its_depth_there) {
  const contact::Law law = std::make_shared<contact::Tsuji>(0.34, 0.009);
  const auto impact = impact::simulate({.mass = {0.14, 40, 0.65},
                                        .law = {law, law},
                                        .gap = {-0.12, -0.0286},
                                        .velocity = {1, -0.7, 0.4},
                                        .precompressed = true});
  BOOST_TEST(impact.contacts[1].peak_force == 0);
  BOOST_TEST(impact.contacts[1].peak_indentation == 0.0286, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_contact_drawn_apart_faster_than_its_damping_allows_goes_slack) {
  // Ball 1 leaves with more than 1/a: all that contact 1 has stored is lost.
  const auto impact =
      impact::simulate({.mass = {1, 1, 0.01},
                        .law = {std::make_shared<contact::HuntCrossley>(1, 5), contact::Hertz{1}},
                        .gap = {-0.5, -0.5},
                        .velocity = {-1, 0, 0},
                        .precompressed = true},
                       {.accuracy = 1e-10});
  BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
  BOOST_TEST(std::abs(impact.contacts[0].dissipated - 0.4 * std::pow(0.5, 2.5)) < 1e-10);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-8);
}

BOOST_AUTO_TEST_CASE(numbers_that_make_no_law_are_refused) {
  BOOST_CHECK_THROW(contact::HuntCrossley(0, 1), InvalidParameter);
  BOOST_CHECK_THROW(contact::HuntCrossley(1, -1), InvalidParameter);
  BOOST_CHECK_THROW(contact::HuntCrossley(1, 1, 0.5), InvalidParameter);
  BOOST_CHECK_THROW(contact::HuntCrossley(1, infinity), InvalidParameter);
}

// a v (1 + e) = ln((1 + a v)/(1 − a e v)) by 40 digits of mpmath: it knows neither stiffness nor exponent.
BOOST_AUTO_TEST_CASE(large_exponents_rise_late_and_are_heard_in_time) {
  for (const double exponent : {6, 10, 14, 20, 32, 45, 60, 100})
    for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
      for (const auto& [speed, restitution] :
           {std::pair{0.3, 0.980391402984922064}, {1.0, 0.937475579949905064}}) {
        const contact::Law law = std::make_shared<contact::HuntCrossley>(1, 0.1, exponent);
        const auto impact = impact::simulate(
            {.mass = {1, 1}, .law = {law}, .gap = {0}, .velocity = {speed, 0}}, {.accuracy = accuracy});
        BOOST_TEST(std::abs(impact.velocity[1] - impact.velocity[0] - restitution * speed) <
                   (accuracy + 1e-13) * speed);
      }
}

BOOST_AUTO_TEST_CASE(so_do_those_of_rows) {
  const auto row = [](const contact::Law& law) {
    return model::Chain{.mass = {1, 1, 1}, .law = {law, law}, .gap = {0, 0}, .velocity = {1, 0, 0}};
  };
  for (const double exponent : {14, 32, 60}) {
    const contact::Viscoelastic lossy{.stiffness = 1, .damping = 0.1, .exponent = exponent};
    for (const auto& chain : {row(lossy), row(std::make_shared<contact::HuntCrossley>(1, 0.1, exponent))}) {
      const auto expected = impact::simulate(chain, {.accuracy = 1e-12, .flow = flow::Kind::cvode_adams});
      for (const double accuracy : {1e-3, 1e-6, 1e-10}) {
        const auto impact = impact::simulate(chain, {.accuracy = accuracy});
        for (int i = 0; i < 3; ++i)
          BOOST_TEST(std::abs(impact.velocity[i] - expected.velocity[i]) < accuracy);
      }
    }
  }
}
