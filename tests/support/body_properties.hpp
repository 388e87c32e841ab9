// What holds for every impact of a microbody, whatever its scene.
#pragma once
#include <boost/test/unit_test.hpp>

#include "support/random_bodies.hpp"

namespace mariotte::test {

/// Energy that a body has gained, over what it had: kinetic and stored, in the state the run has ended in.
inline double gain(const impact::MicrobodyImpact& impact) {
  const auto& e = impact.energy;
  return (e.final + e.stored - e.work - e.initial) / e.initial;
}

/// Kinetic energy never grows, no dissipative term gives any back, the balance balances, and the run ends.
inline void check_passivity(const model::Microbody& body, const hybrid::Options& options) {
  const auto impact = impact::simulate(body, options);
  const auto& e = impact.energy;
  const double noise = 10 * options.accuracy;
  BOOST_TEST((impact.ending == hybrid::Ending::separated || impact.ending == hybrid::Ending::captured),
             hybrid::name(impact.ending) << " " << impact.message);
  BOOST_TEST(gain(impact) < noise);
  BOOST_TEST(e.hertz_damping >= 0);
  BOOST_TEST(e.adhesion_damping >= 0);
  BOOST_TEST(e.friction >= -noise * e.initial);
  // What the well of adhesion lends a slow body counts, too.
  const double well = -contact::stored_energy(body.law[0], contact::rest_indentation(body.law[0]));
  BOOST_TEST(std::abs(e.residual) < noise * (e.initial + well));
}

inline void check_many(int count, unsigned seed, Index impacts) {
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i) {
    auto body = random_body(random);
    body.impacts = impacts;
    BOOST_TEST_CONTEXT("scene " << i << " of seed " << seed) {
      check_passivity(body, {.accuracy = 1e-8});
    }
  }
}

}  // namespace mariotte::test
