// The field of two contacts, and its series in the registers of every machine.
#define BOOST_TEST_MODULE triplets in lanes
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "mariotte/flow/triplet/triplet_field.hpp"
#include "mariotte/flow/triplet/triplet_lanes.hpp"
#include "support/field_checks.hpp"

using namespace mariotte;
using namespace mariotte::flow;
using boost::test_tools::tolerance;

namespace {

/// Equal balls; the first strikes at a speed of 1, the second contact approaches at `rate`, from a gap.
Triplet triplet(double ratio, double rate, double gap) {
  Triplet one{.own = {2, 2 * ratio},
              .cross = {ratio, 1},
              .weight = {1, 1},
              .noise_speed = 1e-11,
              .noise_root = 1e-4,
              .same_instant = 1e-10,
              .rate = {1, rate}};
  one.indentation[1] = -gap;
  begin(one);
  return one;
}

std::vector<Triplet> many() {
  std::vector<Triplet> all;
  for (const double ratio : {0.1, 0.7, 1.3, 10.0})
    for (const double rate : {-0.2, 0.0, 0.3, 0.8})
      for (const double gap : {0.0, 0.05, 1.0}) all.push_back(triplet(ratio, rate, gap));
  return all;
}

/// ½ Σ μ_ij δ̇_i δ̇_j with unit masses, less what the mass centre has.
double energy(const Triplet& t) {
  return (t.rate[0] * t.rate[0] + t.rate[0] * t.rate[1] + t.rate[1] * t.rate[1]) / 3;
}

void expect_same(const Triplet& one, const Triplet& expected) {
  for (int j = 0; j < 2; ++j) {
    BOOST_TEST(std::abs(one.rate[j] - expected.rate[j]) < 1e-14);
    BOOST_TEST(one.periods[j] == expected.periods[j]);
  }
  BOOST_TEST(one.time == expected.time, tolerance(1e-13));
}

}  // namespace

BOOST_AUTO_TEST_CASE(everything_agrees_with_two_contacts) {
  test::check<TripletField>({{0.7, 0.4, -0.5, 0.3, 1}, {2, 3, 1.5, 1}});
}

BOOST_AUTO_TEST_CASE(energy_is_kept_and_nothing_approaches_at_the_end) {
  for (const double accuracy : {1e-4, 1e-7, 1e-10, 1e-13}) {
    const auto before = many();
    auto after = before;
    Triplets().follow(after, accuracy);
    for (std::size_t i = 0; i < after.size(); ++i) {
      const auto& one = after[i];
      BOOST_TEST_CONTEXT("triplet " << i << " at " << accuracy) {
        BOOST_TEST((one.stage == TripletStage::over));
        BOOST_TEST(std::abs(energy(one) - energy(before[i])) < 2 * accuracy);
        BOOST_TEST(std::max(one.rate[0], one.rate[1]) <= one.noise_speed);
        BOOST_TEST(std::max(one.indentation[0], one.indentation[1]) <= 0);
        BOOST_TEST(one.periods[0] >= 1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(lanes_of_every_kind_give_the_same) {
  for (const double accuracy : {1e-6, 1e-12}) {
    auto expected = many();
    Triplets(baseline::make_triplet_lanes(Lanewise::scenes)).follow(expected, accuracy);
    for (const auto& make : {make_triplet_lanes, baseline::make_triplet_lanes})
      for (const auto lanewise : {Lanewise::scenes, Lanewise::contacts}) {
        auto all = many();
        Triplets(make(lanewise)).follow(all, accuracy);
        for (std::size_t i = 0; i < all.size(); ++i) expect_same(all[i], expected[i]);
      }
  }
}

BOOST_AUTO_TEST_CASE(balls_of_one_kind_let_go_at_the_known_velocities) {
  auto one = triplet(1, 0, 0);
  Triplets().follow({&one, 1}, 1e-14);
  // Final velocities −0.07095235365143687102, 0.07640303907120699302, 0.99454931458022987800.
  BOOST_TEST(one.rate[0] == -0.07095235365143687102 - 0.07640303907120699302, tolerance(2e-15));
  BOOST_TEST(one.rate[1] == 0.07640303907120699302 - 0.99454931458022987800, tolerance(2e-15));
}
