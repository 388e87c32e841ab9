#define BOOST_TEST_MODULE property_random_bodies_long
#include "support/body_properties.hpp"

using namespace mariotte::test;

BOOST_AUTO_TEST_CASE(kinetic_energy_never_grows_in_ten_thousand_first_impacts) {
  check_many(10000, 2002, 1);
}

BOOST_AUTO_TEST_CASE(kinetic_energy_never_grows_over_many_impacts_of_a_thousand_bodies) {
  check_many(1000, 2003, 20);
}
