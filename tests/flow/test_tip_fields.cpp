// What is derived from the fields of a tip agrees with them.
#define BOOST_TEST_MODULE fields of a tip
#include <boost/test/unit_test.hpp>

#include "mariotte/flow/taylor/tip_expansions.hpp"
#include "support/field_checks.hpp"

using namespace mariotte::flow;
using namespace mariotte::test;

namespace {

/// A damped, adhesive tip on its way in, at an angle.
template <class Field>
Case<Field, double> in_plane() {
  return {{0.3, -0.5, 0.4, 0.2, 0.9, 0.3, 0.1, 0.2, 0.1, 0.1, 0.1},
          {1, 0.3, 0.1, 0.2, 1, 1e-3, 0.1, 0.7, 0.2, 1, -0.6, 0.8, -0.15}};
}
template <bool sticks>
void check_planar() {
  using Field = PlanarField<sticks, true>;
  check<Field>(in_plane<Field>());
}

template <class Field>
Case<Field, double> in_space() {
  Case<Field, double> about{{}, {1, 0.3, 0.1, 0.2, 1, 1e-3, 5, 4, 0.5, 0.2, 0.15, 0.6, 0.48, 0.64}};
  about.start.fill(0.1);
  const double motion[] = {0.3, -0.5, 0.4, 0.2, 0.1, 0.05, -0.06, 0.6, 0.48, 0.64, 0.05};
  std::copy(std::begin(motion), std::end(motion), about.start.begin());
  about.start[Field::direction] = 0.6;
  about.start[Field::direction + 1] = -0.8;
  return about;
}
template <Grip grip>
void check_spatial() {
  using Field = SpatialField<grip, true>;
  check<Field>(in_space<Field>());
}

/// Largest difference of a coefficient, relative to the largest of its order.
template <class Motion>
double apart(const TipPhase& phase, const TipStart<Motion>& from) {
  const auto best = make_tip_expansions(), baseline = baseline::make_tip_expansions();
  const auto *a = best->expand(phase, from, order), *b = baseline->expand(phase, from, order);
  double most = 0;
  for (int k = 0; k <= order; ++k) {
    double size = 0, difference = 0;
    for (int i = 0; i < Motion::rows; ++i) {
      size = std::max(size, std::abs(b[i][k]));
      difference = std::max(difference, std::abs(a[i][k] - b[i][k]));
    }
    most = std::max(most, difference / size);
  }
  return most;
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

BOOST_AUTO_TEST_CASE(all_instruction_sets_expand_alike) {
  const auto plane = in_plane<PlanarField<false, true>>();
  const auto space = in_space<SpatialField<Grip::sliding, true>>();
  TipPhase phase = {};
  phase.friction = 0.15;
  for (const mariotte::Index work : {-1, 0})
    for (const bool sticks : {false, true})
      for (const auto slip : {TipPhase::Slip::moving, TipPhase::Slip::turning})
        for (const bool indented : {false, true}) {
          phase.place.work = work;
          phase.sticking = sticks;
          phase.slip = slip;
          phase.indented = indented;
          BOOST_TEST(apart<PlanarMotion>(phase, {{}, plane.start, plane.parameters}) < 1e-12);
          BOOST_TEST(apart<SpatialMotion>(phase, {{}, space.start, space.parameters}) < 1e-12);
        }
}
