// What is derived from the fields of a tip agrees with them.
#define BOOST_TEST_MODULE fields of a tip
#include <boost/test/unit_test.hpp>

#include "mariotte/flow/taylor/tip_fields.hpp"
#include "support/field_checks.hpp"

using namespace mariotte::flow;
using namespace mariotte::test;

namespace {

/// A damped, adhesive tip on its way in, at an angle.
template <bool sticks>
void check_planar() {
  using Field = PlanarField<sticks, true>;
  check<Field>({{0.3, -0.5, 0.4, 0.2, 0.9, 0.3, 0.1, 0.2, 0.1, 0.1, 0.1},
                {1, 0.3, 0.1, 0.2, 1, 1e-3, 0.1, 0.7, 0.2, 1, -0.6, 0.8, -0.15}});
}

template <Grip grip>
void check_spatial() {
  using Field = SpatialField<grip, true>;
  Case<Field, double> about{{}, {1, 0.3, 0.1, 0.2, 1, 1e-3, 5, 4, 0.5, 0.2, 0.15, 0.6, 0.48, 0.64}};
  about.start.fill(0.1);
  const double motion[] = {0.3, -0.5, 0.4, 0.2, 0.1, 0.05, -0.06, 0.6, 0.48, 0.64, 0.05};
  std::copy(std::begin(motion), std::end(motion), about.start.begin());
  about.start[Field::direction] = 0.6;
  about.start[Field::direction + 1] = -0.8;
  check<Field>(about);
}

}  // namespace

BOOST_AUTO_TEST_CASE(everything_agrees_with_a_tip_that_moves_along_the_normal) {
  check<NormalField<true>>({{0.3, -0.5, 0.1, 0.1, 0.1, 0.1}, {1, 0.3, 0.1, 0.2, 1, 1e-3}});
}

BOOST_AUTO_TEST_CASE(everything_agrees_with_a_tip_in_a_plane) {
  check_planar<false>();
  check_planar<true>();
}

BOOST_AUTO_TEST_CASE(everything_agrees_with_a_tip_in_space) {
  check_spatial<Grip::sinking_sliding>();
  check_spatial<Grip::sticking>();
  check_spatial<Grip::from_rest>();
}
