// Slopes of runs in which contacts close and open in pairs at one instant, and of contacts that touch and are
// never pressed.
#define BOOST_TEST_MODULE impact_slopes_in_pairs
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <optional>

#include "mariotte/impact/sensitivity/sensitivity.hpp"

using namespace mariotte;

namespace {

template <class Model>
std::optional<double> slope(const Model& model, const hybrid::Options& options, const std::string& outcome,
                            const std::string& parameter) {
  const auto found = impact::sensitivity(model, impact::parameters(model), options);
  for (const auto& one : found.outcome)
    for (std::size_t c = 0; c < found.parameter.size(); ++c)
      if (name_of(one) == outcome && found.parameter[c].name == parameter) return one.slope[c];
  BOOST_FAIL("no slope of " << outcome << " by " << parameter);
  return {};
}

}  // namespace

// Two stiff contacts close and open again and again, as good as together, and parameters draw their times
// apart by thousands of times what they move velocities. Expected: an accuracy of 10⁻¹².
BOOST_AUTO_TEST_CASE(pairs_of_linear_contacts_have_right_slopes_at_every_accuracy) {
  const contact::Linear outer{0.38290688015583291}, stiff{16812.730169550017}, inner{0.17368346859115733};
  const model::Chain chain{
      .mass = {2.9650814266661492, 1.6086577079273376, 0.67966046881102415, 0.5684561725018572,
               0.67966046881102415, 1.6086577079273376, 2.9650814266661492},
      .law = {outer, stiff, inner, inner, stiff, outer},
      .gap = {0, 0.83083577383793772, 0, 0, 0.83083577383793772, 0},
      .velocity = {0.51780586360238234, 0.64242246680228621, 0.92629167968009396, 0, -0.92629167968009396,
                   -0.64242246680228621, -0.51780586360238234}};
  for (const double accuracy : {1e-6, 1e-8, 1e-9, 1e-10, 1e-11}) {
    const auto own = slope(chain, {.accuracy = accuracy}, "velocity[4]", "contact[3].stiffness");
    BOOST_TEST(std::abs(own.value() - 1.530232790773) < 1e-10);
  }
}

// Two light balls rattle for long, each between two heavier ones, and meet these as slowly as late. A mass
// draws the last meetings apart by 10³ indentations. Expected: differences of runs.
BOOST_AUTO_TEST_CASE(pairs_of_slow_meetings_have_slopes_to_five_digits) {
  const double heavy = 13870.709114680463, light = 0.52062057270059692, middle = 2.3701829324438672;
  const double outer = 8.4368527370293557e-10, fast = 5.0421602577943545e-09, slow = 8.9974140826459814e-10;
  const contact::Hertz law(0.0015807628242407016);
  const model::Chain chain{
      .mass = {heavy, light, middle, middle, light, heavy},
      .law = {law, law, law, law, law},
      .gap = {0.00016957332558091115, 0, 8.9388084849844306e-05, 0, 0.00016957332558091115},
      .velocity = {-outer, fast, -slow, slow, -fast, outer}};
  for (const double accuracy : {1e-6, 1e-7, 1e-9})
    BOOST_TEST(
        std::abs(slope(chain, {.accuracy = accuracy}, "velocity[4]", "mass[2]").value() / 6.3506459e-10 - 1) <
        1e-5);
}

// The two contacts in the middle creep, and let go at the end of the run: whichever is the later one.
BOOST_AUTO_TEST_CASE(two_creeping_contacts_end_a_run_at_a_time_without_slope) {
  const contact::Viscoelastic outer{0.9858824552228127, 0.16696211328834348, 1.5};
  const contact::Viscoelastic next{1.0046568791924424, 0.10388942896281413, 1.5};
  const contact::Viscoelastic inner{0.98530566220486204, 72.467883654487409, 1.5};
  const model::Chain chain{.mass = {1, 1, 1, 1, 1, 1, 1},
                           .law = {outer, next, inner, inner, next, outer},
                           .gap = {0, 0.31751434032638381, 0, 0, 0.31751434032638381, 0},
                           .velocity = {0.37565789594376842, 0.69375217210253282, -0.25509114544593747, 0,
                                        0.25509114544593747, -0.69375217210253282, -0.37565789594376842}};
  for (const double accuracy : {1e-6, 1e-8, 1e-9, 1e-10, 1e-11})
    BOOST_TEST(!slope(chain, {.accuracy = accuracy}, "time", "contact[0].exponent"));
}

// A disc strikes one that rests against two others, which touch and are driven apart.
BOOST_AUTO_TEST_CASE(a_damper_of_a_contact_that_is_never_pressed_has_no_effect) {
  const double c = 0.5, s = std::sqrt(3) / 2;
  const model::Network network{
      .mass = {1, 1, 1, 1, 1, 1, 0.48, 0.48},
      .direction = {{{0, -s}, {1, c}, {2, s}, {3, -c}},
                    {{0, -s}, {1, -c}, {4, s}, {5, c}},
                    {{0, 1}, {6, -1}},
                    {{3, -1}, {5, 1}}},
      .law = {contact::Viscoelastic{1.06, 0.019, 1}, contact::Viscoelastic{0.61, 0.19, 1},
              contact::Viscoelastic{0.46, 0.36, 1}, contact::Viscoelastic{0.95, 655128.8, 1}},
      .gap = {0, 0, 0.1, 0},
      .velocity = {0, 0, 0, 0, 0, 0, 1, -0.42}};
  for (const double accuracy : {1e-6, 1e-8, 1e-10})
    for (const std::string number : {"damping", "stiffness"})
      BOOST_TEST(
          slope(network, {.accuracy = accuracy, .max_time = 300}, "velocity[2]", "contact[3]." + number)
              .value() == 0);
}
