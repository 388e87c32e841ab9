#define BOOST_TEST_MODULE study_measurements
#include <boost/test/unit_test.hpp>

#include "mariotte/scene/scene.hpp"
#include "mariotte/study/fit/measurements.hpp"

using namespace mariotte;
using study::parse_measurements;

namespace {

std::string rejection(const std::string& text) {
  try {
    parse_measurements(text, "data.csv");
    return "";
  } catch (const scene::SceneError& error) {
    return error.what();
  }
}

bool refuses(const std::string& text, const std::string& message) {
  const auto why = rejection(text);
  BOOST_TEST_INFO("says \"" << why << "\"");
  return why.find(message) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(words_stand_for_keys_and_units_may_be_in_header_or_cell) {
  const auto found = parse_measurements(
      "diameter [um],speed,incidence.angles[1] [deg],restitution,deviation\n4.9,5 m/s,20,0.8,0.01\n", "f");
  BOOST_TEST_REQUIRE(found.settings.size() == 3u);
  BOOST_TEST(found.settings[0].key == "body.radius");
  BOOST_TEST(found.settings[1].key == "incidence.normal_speed");
  BOOST_TEST(found.settings[2].key == "incidence.angles[1]");
  const auto& row = found.rows.at(0);
  BOOST_TEST(std::get<double>(row.values[0].value) == 0.5 * 4.9e-6, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(std::get<std::string>(row.values[1].value) == "5 m/s");
  BOOST_TEST(std::get<std::string>(row.values[2].value) == "20 deg");
  BOOST_TEST(row.measured == 0.8);
  BOOST_TEST(row.deviation == 0.01);
  BOOST_TEST(found.weighted);
}

BOOST_AUTO_TEST_CASE(a_unit_stands_in_the_header_or_in_the_cell) {
  BOOST_TEST(refuses("speed [mm/s],restitution\n5 m/s,0.8\n",
                     "data.csv:2:1: the header gives the unit already: 'mm/s'"));
}

BOOST_AUTO_TEST_CASE(restitution_is_of_the_tip_unless_the_header_says_of_the_centre) {
  for (const auto* name : {"restitution", "restitution.tip"})
    BOOST_TEST((parse_measurements(std::string("speed,") + name + "\n5,0.8\n", "f").quantity == name));
  const auto centre = parse_measurements("speed,restitution.centre\n5,-0.1\n", "f");
  BOOST_TEST(centre.quantity == "restitution.centre");
  BOOST_TEST(centre.rows[0].measured == -0.1);
  BOOST_TEST(!centre.weighted);
}

BOOST_AUTO_TEST_CASE(a_restitution_that_cannot_be_is_refused_where_it_stands) {
  BOOST_TEST(
      refuses("speed,restitution\n5,0.8\n6,1.2\n", "data.csv:3:3: a restitution must be between 0 and 1"));
  BOOST_TEST(
      refuses("speed,restitution.tip\n5,-0.5\n", "data.csv:2:3: a restitution must be between 0 and 1"));
  BOOST_TEST(refuses("speed,restitution\n5,45\n", "(45 % is 0.45)"));
  const auto noisy = parse_measurements("speed,restitution\n5,1.02\n0.1,-0.03\n", "f");
  BOOST_TEST(noisy.rows[0].measured == 1.02);
  BOOST_TEST(noisy.rows[1].measured == -0.03);
}

BOOST_AUTO_TEST_CASE(the_table_of_a_sweep_can_be_read) {
  const auto found = parse_measurements(
      "incidence.normal_speed,restitution.tip,ending,reason\n5,0.8,separated,\n1,0,captured,\"a, b\"\n", "f");
  BOOST_TEST(found.settings.size() == 1u);
  BOOST_TEST(found.rows.size() == 2u);
}

BOOST_AUTO_TEST_CASE(columns_that_are_missing_unknown_or_given_twice_are_refused) {
  BOOST_TEST(refuses("speed,e\n5,0.8\n", "data.csv:1:7: 'e' is no column of measurements"));
  BOOST_TEST(refuses("sped,restitution\n5,0.8\n", "(did you mean 'speed'?)"));
  BOOST_TEST(refuses("speed,restitution.tp\n5,0.8\n", "(did you mean 'restitution.tip'?)"));
  BOOST_TEST(refuses("speed\n5\n", "data.csv:1:1: the column 'restitution' is missing"));
  BOOST_TEST(refuses("restitution\n0.8\n", "no column says what differs between the rows"));
  BOOST_TEST(
      refuses("speed,restitution,restitution.tip\n5,1,1\n", "data.csv:1:19: 'restitution' is given, too"));
  BOOST_TEST(
      refuses("diameter,body.radius,restitution\n5,5,1\n", "'body.radius' is set by another column, too"));
}

BOOST_AUTO_TEST_CASE(other_separators_than_commas_are_named) {
  for (const auto* text : {"speed;restitution\n5;0,8\n", "speed\trestitution\n5\t0.8\n"})
    BOOST_TEST(refuses(text, "data.csv:1:1: cells are separated by commas"));
}

BOOST_AUTO_TEST_CASE(a_bad_cell_is_refused_at_its_line_and_column) {
  BOOST_TEST(refuses("speed,restitution\n5,0.8\n6,o.8\n", "data.csv:3:3: "));
  BOOST_TEST(refuses("speed,restitution\n5,\n", "data.csv:2:3: "));
  BOOST_TEST(refuses("speed,restitution\n5,inf\n", "data.csv:2:3: must be finite"));
  BOOST_TEST(refuses("speed,restitution\n,0.8\n", "data.csv:2:1: the value of 'speed' is missing"));
  BOOST_TEST(refuses("speed,diameter [kg],restitution\n5,4,0.8\n", "data.csv:2:3: "));
  BOOST_TEST(refuses("speed,restitution,deviation\n5,0.8,0\n", "data.csv:2:7: must be positive"));
}
