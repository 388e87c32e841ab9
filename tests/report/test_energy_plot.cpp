#define BOOST_TEST_MODULE report_energy_plot
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/report/figure/energy_plot.hpp"
#include "mariotte/report/figure/plot.hpp"

using namespace mariotte;

namespace {

model::Chain balls(contact::Law law) {
  return {.mass = {1, 1, 1}, .law = {law, law}, .gap = {0, 0.1}, .velocity = {1, 0, -0.5}};
}

report::EnergyCourse course_of(const model::Chain& chain, impact::ChainImpact& impact) {
  impact = impact::simulate(chain, {}, {.trace = true});
  return report::energy_course(impact, chain);
}

}  // namespace

BOOST_AUTO_TEST_CASE(elastic_contacts_lose_nothing_at_any_instant) {
  impact::ChainImpact impact;
  for (const auto& law : {contact::Law(contact::Hertz{1}), contact::Law(contact::Linear{1})}) {
    const auto course = course_of(balls(law), impact);
    BOOST_TEST(*std::max_element(course.stored.begin(), course.stored.end()) > 0.1);
    for (const double lost : course.lost)
      BOOST_TEST(std::abs(lost) < 1e-8);  // accuracy 1e-10 of unit energies
  }
}

BOOST_AUTO_TEST_CASE(what_is_lost_in_the_end_is_what_the_balance_says) {
  impact::ChainImpact impact;
  const auto course = course_of(balls(contact::Viscoelastic{1, 0.2, 1.5}), impact);
  BOOST_TEST(impact.energy.dissipated > 0.01);
  BOOST_TEST(course.lost.back() == impact.energy.dissipated, boost::test_tools::tolerance(1e-7));
  BOOST_TEST(course.kinetic.back() == impact.energy.final, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(course.stored.back() == 0);
}

// kelvin-voigt lets go while it is indented, and the force of the last sample is rounding.
BOOST_AUTO_TEST_CASE(a_contact_that_has_let_go_stores_nothing) {
  const model::Chain pair{
      .mass = {1, 1}, .law = {contact::Viscoelastic{100, 3, 1}}, .gap = {0}, .velocity = {1, 0}};
  impact::ChainImpact impact;
  const auto course = course_of(pair, impact);
  BOOST_TEST(impact.gap[0] < -0.01);
  BOOST_TEST(course.stored.back() == 0);
  BOOST_TEST(course.lost.back() == impact.energy.dissipated, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(work_of_a_moving_wall_is_no_loss) {
  const model::Chain pushed{
      .mass = {infinity, 1}, .law = {contact::Hertz{1e6}}, .gap = {0}, .velocity = {1, 0}};
  impact::ChainImpact impact;
  BOOST_TEST(course_of(pushed, impact).lost.empty());
  auto struck = pushed;
  struck.velocity = {0, -1};
  BOOST_TEST(!course_of(struck, impact).lost.empty());
}

BOOST_AUTO_TEST_CASE(gaps_do_not_tell_what_a_contact_with_a_memory_stores) {
  BOOST_TEST(report::knows_energies(balls(contact::Viscoelastic{1, 0.2, 1.5})));
  BOOST_TEST(!report::knows_energies(balls(contact::state(contact::WaltonBraun(1, 2)))));
}

BOOST_AUTO_TEST_CASE(a_fall_is_sampled_and_its_energy_a_parabola) {
  const model::Chain drop{
      .mass = {infinity, 2}, .law = {contact::Hertz{1e9}}, .gap = {0.1}, .velocity = {0, 0}, .gravity = 9.81};
  impact::ChainImpact impact;
  const auto course = course_of(drop, impact);
  const double touch = impact.events.at(0).time;
  int inside = 0;
  for (std::size_t i = 0; i < course.time.size() && course.time[i] < touch; ++i, ++inside)
    BOOST_TEST(std::abs(course.kinetic[i] - std::pow(9.81 * course.time[i], 2)) < 1e-12);
  BOOST_TEST(inside > 20);
}

BOOST_AUTO_TEST_CASE(with_gravity_nothing_is_said_about_losses) {
  auto chain = balls(contact::Hertz{1});
  chain.gravity = 1;
  impact::ChainImpact impact;
  const auto course = course_of(chain, impact);
  BOOST_TEST(course.lost.empty());
  BOOST_TEST(report::energy_script(course, "", {{1, "s", 3}, {{0, 1}}, {}}).find("dissipated") ==
             std::string::npos);
  BOOST_TEST(report::energy_csv(course).starts_with("time [s],kinetic [J],stored [J],dissipated [J]\n"));
}

BOOST_AUTO_TEST_CASE(a_fall_has_a_panel_beside_that_of_the_impact) {
  const model::Chain drop{
      .mass = {infinity, 2}, .law = {contact::Hertz{1e9}}, .gap = {0.1}, .velocity = {0, 0}, .gravity = 9.81};
  impact::ChainImpact impact;
  const auto course = course_of(drop, impact);
  const auto axis = report::plot(impact, "").axis;
  BOOST_TEST_REQUIRE(axis.windows.size() == 1u);
  BOOST_TEST(axis.windows[0].start > 0.9 * impact.events.at(0).time);
  const auto script = report::energy_script(course, "", axis);
  BOOST_TEST(script.find("set xrange [0:") != std::string::npos);
  BOOST_TEST(script.find("set border 1\n") != std::string::npos);  // of the second panel
  auto chosen = axis;
  chosen.is_chosen = true;
  BOOST_TEST(report::energy_script(course, "", chosen).find("set xrange [0:") == std::string::npos);
}
