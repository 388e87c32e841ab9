// What is derived from the field of cubic segments agrees with it.
#define BOOST_TEST_MODULE field of cubic segments
#include <boost/test/unit_test.hpp>

#include "mariotte/flow/taylor/row_fields.hpp"
#include "support/field_checks.hpp"

BOOST_AUTO_TEST_CASE(everything_agrees_with_a_contact_on_a_curve) {
  mariotte::test::check<mariotte::flow::taylor::CubicField>(
      {{0.7, 0.5, 0.1, 0.1, 1, 0.1}, {0.4, 0.6, 2.1, -0.7, 0.9}});
}
