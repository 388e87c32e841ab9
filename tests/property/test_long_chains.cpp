#define BOOST_TEST_MODULE long chains
#include <boost/test/unit_test.hpp>

#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

// Behind the wave velocities fall off like 0.45^i, below any accuracy after some 30 balls. What happens there
// must not show as events.
BOOST_AUTO_TEST_CASE(contacts_whose_motion_is_below_the_accuracy_make_no_events) {
  for (const std::size_t balls : {40u, 60u, 100u}) {
    for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
      const auto impact = impact::simulate(equal_chain(balls), {.accuracy = accuracy});
      BOOST_TEST_CONTEXT(balls << " balls at " << accuracy) {
        BOOST_TEST((impact.ending == hybrid::Ending::separated));
        BOOST_TEST(impact.events.size() == balls);
        for (const auto count : period_counts(impact)) BOOST_TEST(count == 1u);
        BOOST_TEST(std::abs(impact.energy.residual) < 100 * accuracy);
      }
    }
  }
}

// Reference values in extended precision; the last force of n balls ends (n − 100) · 1.18975… later.
BOOST_AUTO_TEST_CASE(a_chain_of_a_hundred_balls_is_right_from_end_to_end) {
  const auto impact = impact::simulate(equal_chain(100));
  BOOST_TEST(std::abs(impact.velocity[0] + 0.0710850170860943) < 1e-10);
  BOOST_TEST(std::abs(impact.velocity[1] + 0.0302737893644727) < 1e-10);
  BOOST_TEST(std::abs(impact.velocity[98] - 0.148600463236243) < 1e-10);
  BOOST_TEST(std::abs(impact.velocity[99] - 0.985678857090035) < 1e-10);
  BOOST_TEST(std::abs(impact.time - 119.228764299681853) < 1e-8);
  BOOST_TEST(std::abs(impact.contacts[0].peak_force - 0.758420340911680) < 1e-10);
  BOOST_TEST(std::abs(impact.contacts[50].peak_force - 0.639554232124447) < 1e-10);
  BOOST_TEST(std::abs(impact.contacts[98].peak_force - 0.624182774539055) < 1e-10);
}
