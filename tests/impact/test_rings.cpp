// Rows and networks whose contacts have a ring of adhesion: series against CVODE, which asks the law itself.
#define BOOST_TEST_MODULE rings of adhesion
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/contact/brach_dunn_law.hpp"
#include "support/networks.hpp"
#include "support/reference_laws.hpp"
#include "support/series_against_adams.hpp"

using namespace mariotte;
using hybrid::Ending;
using test::SeriesAgainstAdams;

namespace {

/// What adhesion holds in comparison with an impact of mass 1 at speed 1, and both dampings at that speed.
contact::Law ring(double work, double damping_hertz, double damping_adhesion) {
  return contact::state(contact::BrachDunnLaw(0.75, 1, work, damping_hertz, damping_adhesion));
}

}  // namespace

BOOST_AUTO_TEST_CASE(rows_are_those_that_cvode_follows) {
  std::mt19937_64 random(1971);
  std::uniform_real_distribution<double> share(0, 1);
  SeriesAgainstAdams both;
  for (int i = 0; i < 60; ++i) {
    const auto contacts = 1 + random() % 5;
    model::Chain row{.mass = {1}, .law = {}, .gap = {}, .velocity = {1}};
    for (std::size_t j = 0; j < contacts; ++j) {
      row.mass.push_back(j + 1 == contacts && i % 3 == 0 ? infinity : 0.3 + 2 * share(random));
      row.velocity.push_back(0);
      row.gap.push_back(0.02 + share(random));
      row.law.push_back(
          ring(std::pow(10, -1 - 4 * share(random)), i % 2 * share(random), i / 2 % 2 * share(random)));
    }
    both.compare(row, 1e-10);
  }
  BOOST_TEST(10 * both.series < both.adams);
}

BOOST_AUTO_TEST_CASE(packings_are_those_that_cvode_follows) {
  std::mt19937_64 random(1972);
  SeriesAgainstAdams both;
  for (const double damping : {0.0, 0.4}) {
    auto network = test::lattice(4, random, [&](Index, Index) { return ring(1e-3, damping, damping); });
    for (double& gap : network.gap) gap += 0.1;
    both.compare(network, 1e-9);
  }
  BOOST_TEST(5 * both.series < both.adams);
}

// Dampers, yields and pulls of other laws stand beside it in a series of powers.
BOOST_AUTO_TEST_CASE(rings_stand_beside_other_laws) {
  const contact::Viscoelastic lossy{.stiffness = 1, .damping = 0.3, .exponent = 1.5};
  const auto named = [](nlohmann::json law) { return test::law_of(law); };
  const std::vector<contact::Law> others = {
      contact::Hertz{2}, lossy,
      named({{"law", "walton-braun"}, {"loading_stiffness", 1}, {"unloading_stiffness", 3}}),
      named({{"law", "dmt"}, {"effective_modulus", 1}, {"effective_radius", 1}, {"work_of_adhesion", 1e-3}})};
  for (const auto& other : others)
    for (const double damping : {0.0, 0.3}) {
      const model::Chain row{.mass = {1, 0.5, 1, 2},
                             .law = {ring(1e-3, damping, 0), other, ring(1e-2, 0, damping)},
                             .gap = {0.1, 0.2, 0.3},
                             .velocity = {1, 0, 0, -1}};
      SeriesAgainstAdams().compare(row, 1e-10);
    }
}

// A pair leaves with the speed with which it came: at δ = 0 the ring has given and taken nothing.
BOOST_AUTO_TEST_CASE(a_ring_without_damping_loses_nothing) {
  for (const double work : {1e-6, 1e-3, 0.1}) {
    const model::Chain pair{.mass = {1, infinity}, .law = {ring(work, 0, 0)}, .gap = {1}, .velocity = {1, 0}};
    const auto impact = impact::simulate(pair, {.accuracy = 1e-13});
    BOOST_TEST((impact.ending == Ending::separated));
    BOOST_TEST(std::abs(impact.velocity[0] + 1) < 1e-13);
  }
}

// In metres, kilogrammes and seconds a grain of five micrometres is what it is in its own units.
BOOST_AUTO_TEST_CASE(a_ring_has_no_unit_of_its_own) {
  const double length = 5e-6, mass = 7e-13, speed = 0.15,
               pressure = mass * speed * speed / std::pow(length, 3);
  const auto impact = [](double l, double m, double v, double p) {
    const auto law = contact::state(contact::BrachDunnLaw(0.75 * p, l, 1e-2 * p * l, 0.2 / v, 0.1 / v));
    const model::Chain row{
        .mass = {m, m, m}, .law = {law, law}, .gap = {0.1 * l, 0.3 * l}, .velocity = {v, 0, 0}};
    return impact::simulate(row, {.accuracy = 1e-12});
  };
  const auto own = impact(1, 1, 1, 1), stated = impact(length, mass, speed, pressure);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(stated.velocity[i] / speed - own.velocity[i]) < 1e-12);
}
