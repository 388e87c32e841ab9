// Contacts of bodies have one number each, that of the list of results, in events, figures and samples.
#define BOOST_TEST_MODULE report_contacts_of_bodies
#include <boost/test/unit_test.hpp>

#include "mariotte/report/csv/csv.hpp"
#include "mariotte/report/figure/plot.hpp"

using namespace mariotte;

namespace {

/// Three may touch, the first and the last do.
impact::BodiesImpact two_of_three() {
  impact::BodiesImpact impact;
  impact.dimension = 2;
  impact.body.resize(1);
  for (const Index contact : {0, 2}) {
    auto& one = impact.contacts.emplace_back();
    one.contact = contact;
    one.periods.push_back({0, 4e-5});
  }
  for (const double time : {0.0, 5e-5}) {
    impact.trace.time.push_back(time);
    impact.trace.body.emplace_back(1);
    impact.trace.gap.push_back({0, 0.5, 0.25});
    impact.trace.force.push_back({2e4, 0, 4e4});
    impact.trace.friction.emplace_back(3);
    impact.trace.slip.emplace_back(3);
  }
  impact::BodiesEvents end{.time = 4e-5};
  end.all[static_cast<std::size_t>(model::BodyEvent::open)] = {1};
  impact.events = {end};
  return impact;
}

const report::CurveNames names{.velocities = {"rod x", "rod y"},
                               .contacts = {"floor–rod.1", "floor–rod.2", "wall_1–rod.2"},
                               .dimension = 2};

}  // namespace

BOOST_AUTO_TEST_CASE(curves_name_the_numbers_that_events_have) {
  const auto text = report::plot(two_of_three(), "", names).script;
  for (const char* part : {"'f_{1} (floor–rod.1)'", "'f_{2} (wall\\_1–rod.2)'", " 2 opens}"})
    BOOST_TEST(text.find(part) != std::string::npos, part << "\n" << text);
  BOOST_TEST(text.find("(floor–rod.2)") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(friction_and_spins_have_figures_unless_they_are_zero) {
  auto impact = two_of_three();
  BOOST_TEST(report::plot(impact, "", names).figures == (std::vector<std::string>{"velocities", "forces"}),
             boost::test_tools::per_element());
  impact.trace.friction[1][2].e1 = -3e4;
  impact.trace.body[1][0].spin.e3 = 7;
  auto named = names;
  named.bodies = {"rod"};
  const auto plot = report::plot(impact, "", named);
  BOOST_TEST(plot.figures == (std::vector<std::string>{"velocities", "forces", "friction", "spins"}),
             boost::test_tools::per_element());
  for (const char* part :
       {"'f_{t,2} (wall\\_1–rod.2) x'", "'friction f_t [kN]'", "'rod' at", "'spin ω [rad/s]'"})
    BOOST_TEST(plot.script.find(part) != std::string::npos, part << "\n" << plot.script);
  for (const char* part : {"(wall\\_1–rod.2) y", "f_{t,1}"})
    BOOST_TEST(plot.script.find(part) == std::string::npos, part);
}

BOOST_AUTO_TEST_CASE(friction_of_many_contacts_is_shown_by_its_magnitude) {
  auto impact = two_of_three();
  impact.contacts.clear();
  auto named = names;
  named.contacts.clear();
  for (Index j = 0; j < 7; ++j) {
    auto& one = impact.contacts.emplace_back();
    one.contact = j;
    one.periods.push_back({0, 4e-5});
    named.contacts.push_back("floor–body " + std::to_string(j + 1));
  }
  for (auto& row : impact.trace.gap) row.assign(7, 0);
  for (auto& row : impact.trace.force) row.assign(7, 1);
  for (auto& row : impact.trace.friction) row.assign(7, {3, 4, 0});
  const auto plot = report::plot(impact, "", named);
  BOOST_TEST(plot.script.find("'magnitude of friction f_t [N]'") != std::string::npos);
  BOOST_TEST(plot.data.find("\n1,0,5\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(contacts_that_never_close_have_no_curve) {
  auto impact = two_of_three();
  impact::BodyContactHistory open;
  open.contact = 1;
  impact.contacts.insert(impact.contacts.begin() + 1, open);
  const auto text = report::plot(impact, "", names).script;
  BOOST_TEST(text.find("'f_{3} (wall\\_1–rod.2)'") != std::string::npos, text);
  BOOST_TEST(text.find("f_{2}") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(samples_have_columns_of_the_contacts_that_acted) {
  const auto text = report::trace_csv(two_of_three());
  BOOST_TEST(text.find(",gap2 [m],normal_force2 [N],") != std::string::npos, text);
  BOOST_TEST(text.find("gap3") == std::string::npos);
  BOOST_TEST(text.find(",0.25,40000,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_image_names_the_lines_of_contacts_by_their_numbers) {
  auto impact = two_of_three();
  const auto closed = impact.contacts.front();
  for (Index contact = 3; contact < 20; ++contact) {
    auto& one = impact.contacts.emplace_back(closed);
    one.contact = contact;
    if (contact % 4 == 0) one.periods.clear();
  }
  auto named = names;
  named.contacts.resize(20, "a–b");
  for (std::size_t k = 0; k < impact.trace.time.size(); ++k) {
    impact.trace.gap[k].resize(20, 0);
    impact.trace.force[k].resize(20, 1e4);
    impact.trace.friction[k].resize(20);
  }
  // Contacts 4, 8, 12 and 16 have never closed; as results list them, they are 4, 8, 12 and 16 of 19.
  const auto script = report::plot(impact, "", named).script;
  BOOST_TEST(script.find("set ytics (\"1\" 1, \"2\" 2, \"3\" 3, \"5\" 4, ") != std::string::npos, script);
  BOOST_TEST(script.find("\"19\" 15)") != std::string::npos, script);
}
