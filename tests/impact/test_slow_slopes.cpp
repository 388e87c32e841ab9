// Slopes of what happens slowly beside the rest: balls that fly along, late meetings, contacts that creep.
#define BOOST_TEST_MODULE impact_slow_slopes
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

using namespace mariotte;

namespace {

double slope(const impact::Sensitivity& found, const std::string& outcome, const std::string& parameter) {
  for (const auto& one : found.outcome)
    for (std::size_t c = 0; c < found.parameter.size(); ++c)
      if (name_of(one) == outcome && found.parameter[c].name == parameter) return one.slope[c].value();
  BOOST_FAIL("no slope of " << outcome << " by " << parameter);
  return 0;
}

template <class Model>
impact::Sensitivity slopes_of(const Model& model, double accuracy) {
  return impact::sensitivity(model, impact::parameters(model), {.accuracy = accuracy});
}

/// The approach is a millionth of the velocity, and a number that doubles have.
constexpr double common = 0x1p14, approach = 0x1p-26;
const std::vector<double> flying = {common + approach, common};

/// p = 2 m* (v₁ − v₂), and the time is that of the flight but for a trifle.
void expect_slopes_of_pair(const impact::Sensitivity& found) {
  const double reduced = 2.0 * 3.0 / 5.0;
  for (const auto& one : found.outcome)
    if (one.name == "impulse") BOOST_TEST(std::abs(*one.value / (2 * reduced * approach) - 1) < 1e-9);
  BOOST_TEST(std::abs(slope(found, "impulse[0]", "velocity[0]") / (2 * reduced) - 1) < 1e-9);
  BOOST_TEST(std::abs(slope(found, "impulse[0]", "mass[0]") / (2 * 9.0 / 25.0 * approach) - 1) < 1e-9);
  BOOST_TEST(std::abs(slope(found, "time", "gap[0]") * approach - 1) < 1e-9);
}

}  // namespace

BOOST_AUTO_TEST_CASE(balls_that_fly_along_have_the_slopes_of_their_own_frame) {
  const model::Chain chain{.mass = {2, 3}, .law = {contact::Linear{1}}, .gap = {0.25}, .velocity = flying};
  const auto found = slopes_of(chain, 1e-10);
  expect_slopes_of_pair(found);
  BOOST_TEST(found.outcome[0].value.value() == common + 0.2 * -approach, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(so_have_networks) {
  const model::Network network{.mass = {2, 3},
                               .direction = {{{0, -1}, {1, 1}}},
                               .law = {contact::Linear{1}},
                               .gap = {0.25},
                               .velocity = flying};
  expect_slopes_of_pair(slopes_of(network, 1e-10));
}

// A damper of 10⁵ times the rate of the impact makes much of what rounding leaves of a common velocity 18
// times as large as the rest.
BOOST_AUTO_TEST_CASE(balls_that_fly_along_not_much_faster_have_slopes_as_right_as_any) {
  const model::Chain chain{
      .mass = {0.00020710139420795543, 0.0024906036280457336, 0.0011797832958638293},
      .law = {contact::Viscoelastic{3.2899880893398518e-13, 2.4330664977095734e-13, 2.9982238083177331},
              contact::Viscoelastic{0.022693103903174978, 3133.6818927527033, 1}},
      .gap = {0, 0},
      .velocity = {-6737110.2219770476, -6855667.6139052706, -7136611.2647825619}};
  const auto found = slopes_of(chain, 1e-10);
  BOOST_TEST(slope(found, "velocity[2]", "mass[1]") == 19349206.605, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(slope(found, "time", "mass[1]") == 62.4740201441, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(slopes_that_are_swept_back_fly_along_too) {
  const model::Chain chain{.mass = {2, 3, 1},
                           .law = {contact::Hertz{1}, contact::Hertz{2}},
                           .gap = {0.25, 0},
                           .velocity = {flying[0], common, common}};
  auto still = chain;
  for (double& v : still.velocity) v -= common;
  const std::vector<double> last = {0, 0, 1};
  const auto fast = impact::adjoint(chain, last), slow = impact::adjoint(still, last);
  BOOST_TEST(fast.value == slow.value + common, boost::test_tools::tolerance(1e-15));
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(fast.slopes.mass[i] == slow.slopes.mass[i], boost::test_tools::tolerance(1e-9));
}

// Its slopes at fixed time are 10⁴ times those of what comes of it.
BOOST_AUTO_TEST_CASE(a_late_and_slow_meeting_has_slopes_as_right_as_asked) {
  const model::Chain chain{.mass = {0.47, 1.02, 0.42},
                           .law = {contact::Hertz{1}, contact::Viscoelastic{0.9, 0.32, 1.5}},
                           .gap = {0, 0.87},
                           .velocity = {-0.47, 0.02655, 0.02652}};
  const double exact = slope(slopes_of(chain, 1e-12), "impulse[1]", "velocity[1]");
  for (const double accuracy : {1e-6, 1e-8, 1e-10})
    BOOST_TEST(std::abs(slope(slopes_of(chain, accuracy), "impulse[1]", "velocity[1]") - exact) <=
               10 * accuracy);
}

// δ = A e^{st} + B e^{ft}; its load vanishes where e^{(s − f) t} = −B (k + c f)/(A (k + c s)).
BOOST_AUTO_TEST_CASE(a_contact_that_creeps_has_the_slope_of_its_end) {
  const double k = 0.95, c = 40, depth = 0.0107, rate = 0.08;
  const model::Chain chain{.mass = {1, 1},
                           .law = {contact::Viscoelastic{k, c, 1}},
                           .gap = {-depth},
                           .velocity = {rate, 0},
                           .precompressed = true};
  const double root = std::sqrt(c * c - 2 * k), slow = root - c, fast = -root - c;
  const double a = (rate - fast * depth) / (slow - fast), b = depth - a;
  const double by_rate = (-1 / (slow - fast) / b - 1 / (slow - fast) / a) / (slow - fast);
  const double time = std::log(-b * (k + c * fast) / (a * (k + c * slow))) / (slow - fast);
  for (const double accuracy : {1e-6, 1e-8, 1e-9, 1e-10}) {
    const auto found = slopes_of(chain, accuracy);
    const double own = slope(found, "time", "velocity[0]");
    BOOST_TEST(std::abs(own / by_rate - 1) * std::abs(by_rate * rate / time) <= 10 * accuracy);
  }
}

// Rounding of a load that fades slowly is much time, but the state is that of the event all the same.
BOOST_AUTO_TEST_CASE(a_contact_that_lets_go_slowly_leaves_slopes_of_others_alone) {
  const model::Chain chain{
      .mass = {1, 1, 1, 1},
      .law = {contact::Viscoelastic{1, 0.2, 1.3}, contact::Hertz{1}, contact::Viscoelastic{1, 40, 1}},
      .gap = {0, 100, 0.1},
      .velocity = {1, 0, 0.3, -0.2}};
  for (const double accuracy : {1e-8, 1e-10}) {
    const auto found =
        impact::sensitivity(chain, impact::parameters(chain), {.accuracy = accuracy, .max_time = 1.5});
    BOOST_TEST(std::abs(slope(found, "velocity[0]", "velocity[3]")) < 1e-10);
  }
}

// All contacts are linear, so what happens is proportional to the only velocity. The time of the second
// meeting moves by 10¹³ durations of the contact.
BOOST_AUTO_TEST_CASE(a_damped_contact_after_a_very_long_flight_has_slopes_as_right_as_any) {
  const double speed = 0.7;
  const model::Chain chain{.mass = {1.3, 1, 1.7},
                           .law = {contact::Viscoelastic{0.9, 0.2, 1}, contact::Viscoelastic{1, 0.41, 1}},
                           .gap = {0, 7.7e12},
                           .velocity = {speed, 0, 0}};
  const auto found = slopes_of(chain, 1e-10);
  for (const auto& one : found.outcome)
    if (one.name == "velocity" || one.name == "impulse") {
      const double expected = *one.value / speed;
      BOOST_TEST(std::abs(slope(found, name_of(one), "velocity[0]") - expected) < 1e-9, name_of(one));
    }
}

// Energies of the damper have slopes hundreds of times those of velocities, and no outcome needs them. The
// slope is that of differences of runs at 10⁻¹³.
BOOST_AUTO_TEST_CASE(slopes_of_energies_do_not_tell_how_fine_those_of_velocities_are) {
  const model::Chain chain{.mass = {2.9130919932046546, 0.37836265869749403, 0.045466947435648733,
                                    0.02398672122834667, 158.3481390579222},
                           .law = {contact::Viscoelastic{3.6710813223221685, 3.4685497621027315e-05, 2},
                                   contact::Linear{136799206.88129768}, contact::Linear{117083.51407478619},
                                   contact::Viscoelastic{2.7847419642117113, 0, 2}},
                           .gap = {6284.2693782464985, 0, 9401.4218057879643, 0},
                           .velocity = {2309822.4365751501, -2568007.6676677624, -17675208.013049774,
                                        -98264.016244184721, 13751090.697489109}};
  const auto found = slopes_of(chain, 1e-10);
  BOOST_TEST(std::abs(slope(found, "time", "contact[0].exponent") + 0.34213653033) < 3e-10);
}

// Dampers stop balls in a hundred-thousandth of the run. The slope is that of differences of runs at 10⁻¹⁴.
BOOST_AUTO_TEST_CASE(what_stiff_dampers_leave_is_not_taken_for_resolved) {
  const contact::Viscoelastic stiff{264142.40946761263, 59451686.301491022, 1};
  const contact::Viscoelastic last{335273.76958483685, 5983.4667904712824, 1};
  const model::Chain chain{
      .mass = {infinity, 1.0253560168805114, 1.044701355053784, 1.0680436738094383, 1.0973985758973364,
               1.0188721918859069, infinity},
      .law = {stiff, stiff, contact::Viscoelastic{389009.31935306714, 2.2440046775001887, 1},
              contact::Viscoelastic{292078.1991909747, 1.165828903771789, 1}, last, last},
      .gap = {3.5402725657839205, 1.6235237463344721, 2.5747853327600341, 2.7487814310828336, 0,
              2.101337247613194},
      .velocity = {0, 1430.3025542038565, 1557.3972691630065, -960.43983114080572, 798.18347178121451,
                   -305.9199653880757, 0}};
  const auto found = impact::sensitivity(chain, impact::parameters(chain),
                                         {.accuracy = 1e-8, .max_time = 0.0047956307154615897});
  BOOST_TEST(std::abs(slope(found, "velocity[1]", "velocity[2]") - 0.201053795734) < 1e-8);
}

// A ball that swings many times faster than the others do has come to their motion long before the phase
// ends. What is left of its swings, pieces that do not resolve them neither damp nor see. Expected: an
// accuracy of 10⁻¹², and differences of runs.
BOOST_AUTO_TEST_CASE(a_light_ball_between_heavy_ones_has_right_slopes_at_every_accuracy) {
  const auto damped = [](double c) {
    return contact::PowerLaw{.stiffness = 14463.31061213135, .damping = c, .exponent = 1};
  };
  const model::Chain chain{
      .mass = {infinity, 3.6648804509786782e-07, 0.00038075930781143784, 0.00012542346377673435,
               0.00010857829036416285},
      .law = {damped(0.025926666523121863), damped(0.025926666523121863), damped(2.1703942407948298),
              damped(0.0061691294651428181)},
      .gap = {4.1551252720241791, 0, 10.584110780277683, 0},
      .velocity = {0, 55645.307119788064, -198170.09121335502, -186648.72658242076, -151121.04524176716}};
  const double right = 63247385.6618;
  for (const double accuracy : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10})
    BOOST_TEST(std::abs(slope(slopes_of(chain, accuracy), "velocity[1]", "mass[2]") / right - 1) <
               std::max(accuracy, 1e-10));
}

// Two heavy balls squeeze a light one that swings 23 times meanwhile, and let go of it at one instant: pieces
// that do not resolve its swings yet are no noise. Expected: differences of runs.
BOOST_AUTO_TEST_CASE(swings_are_resolved_up_to_where_contacts_let_go) {
  const contact::Linear spring{0.56950353462189618};
  const model::Chain chain{.mass = {48.01425887245086, 0.046597897446894451, 48.01425887245086},
                           .law = {spring, spring},
                           .gap = {0.64623038934839572, 0.64623038934839572},
                           .velocity = {0.80558478808932299, 0, -0.80558478808932299}};
  for (const double accuracy : {1e-6, 1e-8, 1e-10})
    BOOST_TEST(std::abs(slope(slopes_of(chain, accuracy), "velocity[1]", "velocity[0]") + 1.25463949929) <
               1e-8 + accuracy);
}

// A contact closes slowly while another presses: by the clock of its gap all slopes are large at first, and
// those of its impulse small at the end.
BOOST_AUTO_TEST_CASE(slopes_that_shrink_have_the_digits_that_were_asked_for) {
  const model::Chain chain{.mass = {0.82139536235467236, 1.5119518634461586, 3.3140749337933637},
                           .law = {contact::Hertz{15.70477757482926}, contact::Hertz{0.085760467009678765}},
                           .gap = {1.0978408678076627e-07, 2.7174440370574039e-05},
                           .velocity = {1, 0, 0}};
  const auto at = [&](double accuracy) { return slope(slopes_of(chain, accuracy), "impulse[1]", "gap[1]"); };
  const double exact = at(1e-12);
  BOOST_TEST(std::abs(at(1e-6) / exact - 1) < 1e-3);
  BOOST_TEST(std::abs(at(1e-8) / exact - 1) < 1e-5);
}

// 956 times the light ball meets one of the heavy ones. In other units of time nothing changes, so that
// Σ v ∂u/∂v + 2 Σ k ∂u/∂k = u; slopes by the first velocity are those of differences of runs.
BOOST_AUTO_TEST_CASE(a_light_ball_that_rattles_on_linear_contacts_has_slopes) {
  const model::Chain chain{.mass = {1, 1e-6, 2},
                           .law = {contact::Linear{1e9}, contact::Linear{1e9}},
                           .gap = {1e-3, 1e-3},
                           .velocity = {1, 0, 0}};
  const auto found = slopes_of(chain, 1e-10);
  BOOST_TEST(std::abs(slope(found, "velocity[1]", "velocity[0]") - 129.1443902) < 1e-4);
  for (const char* name : {"velocity[0]", "velocity[2]"}) {
    const auto by_stiffness =
        slope(found, name, "contact[0].stiffness") + slope(found, name, "contact[1].stiffness");
    const auto u = std::find_if(found.outcome.begin(), found.outcome.end(),
                                [&](const auto& one) { return name_of(one) == name; });
    BOOST_TEST(std::abs(slope(found, name, "velocity[0]") + 2e9 * by_stiffness - *u->value) < 1e-7);
  }
}
