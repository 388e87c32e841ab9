// Small vibrations about static equilibrium, beside the closed forms of rows and beside runs.
#define BOOST_TEST_MODULE modes
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "mariotte/contact/stated_law.hpp"
#include "mariotte/contact/tabulated.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/modes/vibrations.hpp"
#include "mariotte/model/chain/equilibrium.hpp"

using namespace mariotte;
using std::numbers::pi;

namespace {

/// Balls of one or two masses in turn between two walls, or alone.
model::Chain row(Index balls, double even, double odd, bool walls, double stiffness = 1) {
  model::Chain chain;
  if (walls) chain.mass.push_back(infinity);
  for (Index i = 0; i < balls; ++i) chain.mass.push_back(i % 2 == 0 ? even : odd);
  if (walls) chain.mass.push_back(infinity);
  const auto contacts = chain.mass.size() - 1;
  chain.law.assign(contacts, contact::Hertz(stiffness));
  chain.gap.assign(contacts, 0.0);
  chain.velocity.assign(contacts + 1, 0.0);
  return chain;
}

/// Frequency of mode p over the cut-off.
double wave(Index p, Index balls) {
  return std::sin(static_cast<double>(p) * pi / static_cast<double>(2 * (balls + 1)));
}

void expect_near(double a, double b, double relative) {
  BOOST_TEST(std::abs(a - b) <= relative * std::abs(b), a << " is not " << b);
}

}  // namespace

BOOST_AUTO_TEST_CASE(uniform_rows_have_the_frequencies_of_their_closed_form) {
  constexpr double force = 1e-3, stiffness = 1.5e-1;  // (3/2) k^(2/3) F^(1/3)
  for (const Index balls : {1, 2, 7, 200}) {
    const auto fixed = row(balls, 1, 1, true), free = row(balls + 1, 1, 1, false);
    const auto at_rest = impact::rest(fixed, force);
    expect_near(at_rest.stiffness.front(), stiffness, 1e-14);
    const auto modes = impact::vibrations(fixed, at_rest);
    BOOST_TEST(modes.rigid_motions == 0);
    BOOST_REQUIRE(std::ssize(modes.frequency) == balls);
    for (Index p = 1; p <= balls; ++p)
      expect_near(modes.frequency[p - 1], 2 * std::sqrt(stiffness) * wave(p, balls), 1e-13);
    const auto loose = impact::vibrations(free, impact::rest(free, force));
    BOOST_TEST(loose.rigid_motions == 1);
    BOOST_REQUIRE(std::ssize(loose.frequency) == balls);
    for (Index p = 1; p <= balls; ++p)
      expect_near(loose.frequency[p - 1], 2 * std::sqrt(stiffness) * wave(p, balls), 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(a_row_of_two_masses_has_a_gap_between_its_bands) {
  const auto chain = row(200, 1, 0.4, true);
  const auto rest = impact::rest(chain, 1e-3);
  const auto bands = impact::band_edges(chain, rest);
  BOOST_REQUIRE((bands && bands->optical_bottom && bands->optical_top));
  expect_near(bands->acoustic_top, std::sqrt(2 * 0.15), 1e-14);
  expect_near(*bands->optical_bottom, std::sqrt(2 * 0.15 / 0.4), 1e-14);
  expect_near(*bands->optical_top, std::sqrt(2 * 0.15 * 3.5), 1e-14);
  for (const double w : impact::vibrations(chain, rest).frequency)
    BOOST_TEST((w <= bands->acoustic_top || (w >= *bands->optical_bottom && w <= *bands->optical_top)));
  const auto equal = row(3, 1, 1, true);
  const auto cut_off = impact::band_edges(equal, impact::rest(equal, 1e-3));
  BOOST_REQUIRE(cut_off);
  BOOST_TEST(!cut_off->optical_top);
  expect_near(cut_off->acoustic_top, 2 * std::sqrt(0.15), 1e-14);
  auto mixed = row(4, 1, 0.4, true);
  mixed.mass[3] = 2;
  BOOST_TEST(!impact::band_edges(mixed, impact::rest(mixed, 1e-3)));
}

BOOST_AUTO_TEST_CASE(ends_are_pressed_by_a_positive_force) {
  const model::Chain pair{.mass = {1, 1}, .law = {contact::Hertz{1}}, .gap = {0}, .velocity = {0, 0}};
  for (const double force : {0.0, -1.0, infinity, std::nan("")})
    BOOST_CHECK_THROW(impact::rest(pair, force), InvalidParameter);
}

BOOST_AUTO_TEST_CASE(walls_hold_what_the_gaps_say_wherever_the_balls_stand) {
  auto chain = row(3, 1, 2, true);
  chain.precompressed = true;
  chain.law[1] = contact::Hertz(8);
  chain.gap = {-0.04, 0, -0.01, -0.02};  // together 0.07; the stiffer contact takes a quarter of the others
  const auto rest = impact::rest(chain);
  const double force = std::pow(0.07 / 3.25, 1.5);
  for (const double f : rest.force) expect_near(f, force, 1e-13);
  expect_near(rest.indentation[1], 0.07 / 13, 1e-13);
}

// Its curve runs flat at the end: what is larger than that, the search for the force must not ask for.
BOOST_AUTO_TEST_CASE(walls_hold_contacts_that_never_come_to_some_forces) {
  auto chain = row(1, 1, 1, true);
  chain.precompressed = true;
  chain.gap = {-0.1, -0.1};
  const contact::Tabulated flat({{0.003, 0.0547722557505}, {0.3, 0.547722557505}});
  chain.law.assign(2, contact::SharedLaw(std::make_shared<contact::Tabulated>(flat)));
  const auto rest = impact::rest(chain);
  for (const double f : rest.force) expect_near(f, flat.force(0.1, 0).value, 1e-13);
}

BOOST_AUTO_TEST_CASE(a_column_carries_its_weight) {
  auto chain = row(4, 2, 2, false);
  chain.mass.front() = infinity;
  chain.gravity = 9.81;
  const auto rest = impact::rest(chain);
  for (Index j = 0; j < 3; ++j) expect_near(rest.force[j], static_cast<double>(3 - j) * 2 * 9.81, 1e-15);
}

/// The middle ball between two walls of a network that is pressed out of balance comes to its rest.
BOOST_AUTO_TEST_CASE(a_network_finds_its_rest_and_has_the_modes_of_the_row_that_it_is) {
  auto chain = row(5, 1, 0.4, true);
  chain.precompressed = true;
  chain.gap = {-0.03, -0.01, -0.02, 0, -0.01, -0.02};
  const auto network = as_network(chain);
  const auto rest = impact::rest(chain), found = impact::rest(network);
  const auto a = impact::vibrations(chain, rest), b = impact::vibrations(network, found);
  BOOST_REQUIRE(a.frequency.size() == b.frequency.size());
  for (std::size_t j = 0; j < rest.force.size(); ++j) expect_near(found.force[j], rest.force[j], 1e-12);
  for (std::size_t i = 0; i < a.frequency.size(); ++i) expect_near(b.frequency[i], a.frequency[i], 1e-12);
}

/// A mode that is started alone comes back after one period, as far as the contacts are linear.
BOOST_AUTO_TEST_CASE(a_run_vibrates_at_the_frequency_of_its_mode) {
  auto chain = row(4, 1, 0.4, true);
  model::put_at_rest(chain, 1e-3);
  const auto modes = impact::vibrations(chain, impact::rest(chain));
  for (std::size_t i = 0; i < modes.frequency.size(); ++i) {
    for (std::size_t ball = 1; ball <= 4; ++ball) chain.velocity[ball] = 1e-7 * modes.shape[i][ball];
    const auto impact = impact::simulate(chain, {.accuracy = 1e-10, .max_time = 2 * pi / modes.frequency[i]});
    for (std::size_t ball = 1; ball <= 4; ++ball)
      BOOST_TEST(std::abs(impact.velocity[ball] - chain.velocity[ball]) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(what_has_no_rest_is_refused) {
  auto loose = row(3, 1, 1, false);
  BOOST_CHECK_THROW(impact::rest(loose), InvalidParameter);
  BOOST_CHECK_THROW(impact::rest(loose, 0.0), InvalidParameter);
  loose.gap[1] = 0.1;
  BOOST_CHECK_THROW(impact::rest(loose, 1.0), InvalidParameter);
  auto apart = row(2, 1, 1, true);
  BOOST_CHECK_THROW(impact::rest(apart), InvalidParameter);
  apart.law[1] = contact::state(contact::WaltonBraun(1, 2));
  BOOST_CHECK_THROW(impact::rest(apart, 1.0), InvalidParameter);
}
