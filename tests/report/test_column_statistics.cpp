#define BOOST_TEST_MODULE report_column_statistics
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/report/json/column_statistics.hpp"

using namespace mariotte;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_CASE(statistics_are_those_of_the_sample) {
  report::ColumnStatistics columns("x,icr[0],ending,reason");
  columns.add("1,10,separated,\n4,,separated,\n");
  columns.add("2,30,separated,\n3,20,separated,\n5,40,separated,\nno row\n");
  const auto all = columns.statistics();
  BOOST_TEST(all[0].numbers == 5u);
  BOOST_TEST(all[0].mean == 3);
  BOOST_TEST(all[0].deviation == std::sqrt(2.5));  // Σ(x − 3)² = 10 of five
  BOOST_TEST(all[0].q05 == 1.2, tolerance(1e-14));
  BOOST_TEST(all[0].q50 == 3);
  BOOST_TEST(all[0].q95 == 4.8, tolerance(1e-14));
  BOOST_TEST(all[1].numbers == 4u);
  BOOST_TEST(all[1].q25 == 17.5);
}

BOOST_AUTO_TEST_CASE(statistics_are_named_by_the_key_alone) {
  report::ColumnStatistics columns("x [m/s^2],icr[0],y,ending,reason");
  columns.add("1,2,3,separated,\n");
  const auto all = columns.statistics();
  BOOST_TEST(all[0].key == "x");
  BOOST_TEST(all[0].unit == "m/s^2");
  BOOST_TEST(all[1].unit == "1");
  BOOST_TEST(all[1].key == "icr[0]");
  BOOST_TEST(all[2].key == "y");
}

BOOST_AUTO_TEST_CASE(a_column_without_numbers_has_no_statistics) {
  report::ColumnStatistics columns("x,ending,reason");
  columns.add(",failed,why\n");
  const auto json = columns.json();
  BOOST_TEST(json[0]["numbers"] == 0);
  for (const char* key : {"least", "mean", "deviation", "q50"}) BOOST_TEST(json[0][key].is_null(), key);
}
