// What is derived from the field of contacts that adhere agrees with it.
#define BOOST_TEST_MODULE field of contacts that adhere
#include <boost/test/unit_test.hpp>

#include "mariotte/flow/taylor/row_fields.hpp"
#include "support/field_checks.hpp"

using namespace mariotte::flow::taylor;
using namespace mariotte::test;

// In time, and in the clock of the contact or of another one.
BOOST_AUTO_TEST_CASE(everything_agrees_with_a_contact_that_adheres) {
  check<WidthField<Pace::plain>>(
      {{0.2, 0.5, 0.1, 0.1, 1, 0.1, 0.8}, {3, 0.2, 0.1, -0.05, -0.3, 0.2, 1.2, 0.1, 0, 1}});
  check<WidthField<Pace::landing>>(
      {{0.2, -0.5, 0.1, 0.1, 1.3, 0.1, 0.8}, {3, 0.2, 0.1, -0.05, -0.3, 0.2, 1.2, 0.1, 0, 1}});
  check<WidthField<Pace::landing>>(
      {{0.2, -0.5, 0.1, 0.1, 1.3, 0.1, 0.8}, {3, 0.2, 0.1, -0.05, -0.3, 0.2, 1.2, 0.1, 1, 0}});
}
