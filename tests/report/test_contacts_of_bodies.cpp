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
  for (const Index contact : {0, 2}) impact.contacts.emplace_back().contact = contact;
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

BOOST_AUTO_TEST_CASE(samples_have_columns_of_the_contacts_that_acted) {
  const auto text = report::trace_csv(two_of_three());
  BOOST_TEST(text.find(",gap2 [m],normal_force2 [N],") != std::string::npos, text);
  BOOST_TEST(text.find("gap3") == std::string::npos);
  BOOST_TEST(text.find(",0.25,40000,") != std::string::npos);
}
