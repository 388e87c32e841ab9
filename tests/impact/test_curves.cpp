// Rows and networks whose forces are curves through points: series by segments against CVODE, which asks the
// law.
#define BOOST_TEST_MODULE curves through points
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/contact/tabulated.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "support/driven_rows.hpp"
#include "support/networks.hpp"
#include "support/series_against_adams.hpp"

using namespace mariotte;
using test::SeriesAgainstAdams;

namespace {

contact::Law curve(std::vector<contact::LawPoint> points) {
  return contact::SharedLaw(std::make_shared<contact::Tabulated>(std::move(points)));
}

/// Rising points as far apart as a random process says, up to what bodies of mass and speed 1 reach.
contact::Law random_curve(std::mt19937_64& random, int points) {
  std::uniform_real_distribution<double> share(0.1, 1);
  std::vector<contact::LawPoint> made;
  contact::LawPoint last{.indentation = 0, .force = 0};
  for (int i = 0; i < points; ++i) {
    last.indentation += 2 * share(random) / points;
    last.force += 3 * share(random) / points;
    made.push_back(last);
  }
  return curve(made);
}

}  // namespace

BOOST_AUTO_TEST_CASE(rows_are_those_that_cvode_follows) {
  std::mt19937_64 random(1984);
  std::uniform_real_distribution<double> share(0, 1);
  SeriesAgainstAdams both;
  for (int i = 0; i < 60; ++i) {
    const auto contacts = 1 + random() % 6;
    model::Chain row{.mass = {1}, .law = {}, .gap = {}, .velocity = {1}};
    for (std::size_t j = 0; j < contacts; ++j) {
      row.mass.push_back(j + 1 == contacts && i % 3 == 0 ? infinity : 0.3 + 2 * share(random));
      row.velocity.push_back(0);
      row.gap.push_back(i % 2 * share(random));
      row.law.push_back(random_curve(random, 1 + static_cast<int>(random() % 20)));
    }
    both.compare(row, 1e-10);
  }
  BOOST_TEST(10 * both.series < both.adams);
}

namespace {

using contact::PowerLaw;
constexpr PowerLaw powers[] = {{.stiffness = 2, .exponent = 1.5},
                               {.stiffness = 3, .exponent = 1},
                               {.stiffness = 5, .exponent = 2},
                               {.stiffness = 2, .damping = 0.3, .exponent = 1},
                               {.stiffness = 2, .damping = 0.2, .exponent = 1.5}};

/// Such a curve, or one of the first `kinds` of powers.
contact::Law curve_or_power(std::mt19937_64& random, std::size_t kinds) {
  return random() % 2 == 0 ? random_curve(random, 7) : contact::Law(powers[random() % kinds]);
}

}  // namespace

BOOST_AUTO_TEST_CASE(curves_push_beside_powers) {
  std::mt19937_64 random(1987);
  std::uniform_real_distribution<double> share(0, 1);
  for (const std::size_t kinds : {1, 2, 3, 5}) {
    SeriesAgainstAdams both;
    for (int i = 0; i < 30; ++i) {
      model::Chain row{.mass = {1}, .law = {random_curve(random, 9)}, .gap = {0}, .velocity = {1, 0}};
      row.mass.push_back(0.3 + 2 * share(random));
      for (std::size_t j = 0; j < 1 + random() % 5; ++j) {
        row.mass.push_back(0.3 + 2 * share(random));
        row.velocity.push_back(0);
        row.gap.push_back(i % 2 * 0.1 * share(random));
        row.law.push_back(curve_or_power(random, kinds));
      }
      both.compare(row, 1e-10);
    }
    BOOST_TEST(5 * both.series < both.adams);
  }
}

BOOST_AUTO_TEST_CASE(packings_are_those_that_cvode_follows) {
  std::mt19937_64 random(1985);
  SeriesAgainstAdams both;
  for (const int points : {1, 5, 30})
    both.compare(test::lattice(4, random, [&](Index, Index) { return random_curve(random, points); }), 1e-9);
  both.compare(test::lattice(4, random, [&](Index, Index) { return curve_or_power(random, 2); }), 1e-9);
  BOOST_TEST(5 * both.series < both.adams);
}

BOOST_AUTO_TEST_CASE(driven_rows_are_those_that_cvode_follows) {
  std::mt19937_64 random(1986);
  for (const double gravity : {0.0, 0.2}) {
    model::Chain row{.mass = {infinity, 1, 1, 1},
                     .law = {random_curve(random, 9), powers[0], random_curve(random, 5)},
                     .gap = {0, 0.1, 0.2},
                     .velocity = {0, 0, 0, 0},
                     .gravity = gravity};
    row.drive = {test::drive(0, model::Driven::velocity, model::sine(0.5, 1, 0))};
    SeriesAgainstAdams().compare(row, 1e-10, 4);
  }
}

// A contact that touches is drawn apart by more than its first cubic is wide, and must not pull.
BOOST_AUTO_TEST_CASE(what_is_drawn_apart_has_no_force) {
  for (const double width : {1e-13, 3e-9, 1e-4}) {
    const auto law = curve({{width, 0.5 * width}, {0.3, 0.164}});
    const model::Network network{.mass = {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                 .direction = {{{0, -1}, {1, 1}}, {{1, 1}, {2, 1}}},
                                 .law = {law, law},
                                 .gap = {0, 0},
                                 .velocity = {1, 0, 0}};
    const auto exact = impact::simulate(network, {.accuracy = 1e-12, .flow = flow::Kind::cvode_adams});
    for (const double accuracy : {1e-5, 1e-6, 1e-8, 1e-10}) {
      const auto impact = impact::simulate(network, {.accuracy = accuracy});
      BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
      BOOST_TEST(test::difference(impact.velocity, exact.velocity) < accuracy);
      BOOST_TEST(std::abs(impact.velocity[2]) < 0.01 * accuracy);
    }
  }
}

// The curvature of the force jumps three hundred times.
BOOST_AUTO_TEST_CASE(slopes_beside_powers_are_those_of_differences_of_runs) {
  std::mt19937_64 random(1989);
  const model::Chain chain{.mass = {1, 1.3, 0.8},
                           .law = {contact::Hertz{1}, random_curve(random, 300)},
                           .gap = {0.1, 0.3},
                           .velocity = {1, 0, -0.5}};
  const auto by = impact::parameters(chain);
  const auto found = impact::sensitivity(chain, by);
  BOOST_TEST(found.notes.empty());
  for (std::size_t k = 0; k < by.size(); ++k) {
    const double h = 3e-6;
    const auto at = [&](double offset) {
      return impact::simulate(by[k].model(by[k].value + offset * h), {.accuracy = 1e-14}).velocity;
    };
    const auto a = at(-2), b = at(-1), c = at(1), d = at(2);
    for (std::size_t i = 0; i < chain.mass.size(); ++i) {
      const double expected = ((a[i] - d[i]) + 8 * (c[i] - b[i])) / (12 * h);
      BOOST_TEST(std::abs(found.outcome[i].slope[k].value() - expected) < 2e-9);
    }
  }
}

// Cubics through points of a straight line are that line.
BOOST_AUTO_TEST_CASE(a_straight_curve_is_a_spring) {
  for (const Index balls : {2, 3, 12}) {
    std::vector<contact::LawPoint> points;
    for (const double depth : {0.01, 0.1, 0.3, 0.31, 0.8}) points.push_back({depth, 3 * depth});
    model::Chain row{.mass = std::vector<double>(balls, 1.0),
                     .law = std::vector<contact::Law>(balls - 1, curve(points)),
                     .gap = std::vector<double>(balls - 1, 0.0),
                     .velocity = std::vector<double>(balls, 0.0)};
    row.velocity[0] = 1;
    const auto by_segments = impact::simulate(row, {.accuracy = 1e-13});
    row.law.assign(balls - 1, contact::Linear{3});
    const auto by_springs = impact::simulate(row, {.accuracy = 1e-13});
    BOOST_TEST(by_segments.events.size() == by_springs.events.size());
    BOOST_TEST(test::difference(by_segments.velocity, by_springs.velocity) < 1e-12);
  }
}

// In metres, kilogrammes and seconds a grain of micrometres is what it is in its own units.
BOOST_AUTO_TEST_CASE(a_curve_has_no_unit_of_its_own) {
  const double length = 5e-6, mass = 7e-13, speed = 0.15, force = mass * speed * speed / length;
  const auto impact = [](double l, double m, double v, double f) {
    const auto law = curve({{0.1 * l, 0.05 * f}, {0.4 * l, 0.4 * f}, {0.9 * l, 1.5 * f}, {2 * l, 4 * f}});
    const model::Chain row{.mass = {m, m, 2 * m}, .law = {law, law}, .gap = {0, 0}, .velocity = {v, 0, 0}};
    return impact::simulate(row, {.accuracy = 1e-12});
  };
  const auto own = impact(1, 1, 1, 1), stated = impact(length, mass, speed, force);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(stated.velocity[i] / speed - own.velocity[i]) < 1e-12);
}
