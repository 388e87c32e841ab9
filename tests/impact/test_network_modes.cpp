#define BOOST_TEST_MODULE network modes
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/network/network_balance.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/networks.hpp"
#include "support/random_networks.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::impact;
using test::difference;
using test::Numbers;

namespace {

bool uses(const NetworkImpact& impact, const std::string& flow) {
  return std::any_of(impact.flows.begin(), impact.flows.end(),
                     [&](const auto& use) { return use.name == flow; });
}

/// Modes, and nothing else but flight, follow the network where CVODE goes.
void agrees_with_cvode(const model::Network& network, double allowed, hybrid::Options options = {}) {
  options.accuracy = 1e-12;
  const auto modes = simulate(network, options);
  options.flow = flow::Kind::cvode_bdf_klu;
  const auto cvode = simulate(network, options);
  BOOST_TEST(uses(modes, "modal") == uses(cvode, "cvode-bdf-klu"));  // neither if nothing touches
  BOOST_TEST(!uses(modes, "cvode-adams"));
  BOOST_TEST(!uses(modes, "cvode-bdf-klu"));
  BOOST_TEST((modes.ending == cvode.ending), modes.message);
  BOOST_TEST(difference(modes.velocity, cvode.velocity) < allowed);
  BOOST_TEST(difference(impulses_of(modes), impulses_of(cvode)) < allowed);
  BOOST_TEST(std::abs(modes.energy.residual) < 1e-12 * modes.energy.initial);
  BOOST_TEST(modes.momentum_residual < 1e-13);
  for (std::size_t j = 0; j < network.law.size(); ++j)
    BOOST_TEST(modes.contacts[j].periods.size() == cvode.contacts[j].periods.size());
}

/// A beam with mass, inertia and three feet of which the middle one is redundant; all land one after another.
model::Network beam_on_three_feet(double damping) {
  const auto foot = [](double place) -> ContactDirection { return {{0, 1}, {1, place}}; };
  const auto law = [&](double k) -> contact::Law {
    if (damping == 0) return contact::Linear{k};
    return contact::Viscoelastic{.stiffness = k, .damping = k * damping, .exponent = 1};
  };
  return {.mass = {2, 0.3},
          .direction = {foot(-0.5), foot(0.1), foot(0.5)},
          .law = {law(1), law(20), law(3)},
          .gap = {0, 0.1, 0.05},
          .velocity = {-1, 0.2}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(contacts_that_do_not_move_each_other_have_modes_of_their_own) {
  // Two pairs and a beam, each with a ratio c/k of its own.
  const contact::Law hard = contact::Viscoelastic{.stiffness = 3, .damping = 0.2, .exponent = 1};
  const contact::Law soft = contact::Viscoelastic{.stiffness = 1, .damping = 0.5, .exponent = 1};
  auto network = beam_on_three_feet(0.1);
  network.mass.insert(network.mass.end(), {1, 2, 3, 1});
  network.velocity.insert(network.velocity.end(), {1, 0, 0.7, 0});
  network.direction.insert(network.direction.end(), {{{2, -1}, {3, 1}}, {{4, -1}, {5, 1}}});
  network.law.insert(network.law.end(), {hard, soft});
  network.gap.insert(network.gap.end(), {0, 0.02});
  agrees_with_cvode(network, 1e-9);
  const auto whole = simulate(network, {.accuracy = 1e-12});
  const auto pair = simulate(model::Chain{.mass = {1, 2}, .law = {hard}, .gap = {0}, .velocity = {1, 0}});
  BOOST_TEST(std::abs(whole.velocity[2] - pair.velocity[0]) < 1e-13);
  BOOST_TEST(std::abs(whole.contacts[3].dissipated - pair.contacts[0].dissipated) < 1e-13);
}

BOOST_AUTO_TEST_CASE(lattices_of_linear_contacts_agree_with_cvode) {
  std::mt19937_64 random(41);
  for (const double ratio : {0.0, 0.1, 3.0}) {
    std::uniform_real_distribution<double> decade(-1, 1);
    const auto network = test::lattice(3, random, [&](Index, Index) -> contact::Law {
      const double k = std::pow(10, decade(random));
      if (ratio == 0) return contact::Linear{k};
      return contact::Viscoelastic{.stiffness = k, .damping = ratio * k, .exponent = 1};
    });
    BOOST_TEST_CONTEXT("c/k " << ratio) agrees_with_cvode(network, 1e-9);
  }
}

// Up to ten contacts of ten dofs, coupled all with all, which land one after another and again.
BOOST_AUTO_TEST_CASE(random_linear_networks_agree_with_cvode) {
  std::mt19937_64 random(43);
  std::uniform_real_distribution<double> decade(-2, 2);
  for (int i = 0; i < 60; ++i) {
    const double ratio = i % 3 == 0 ? 0.3 : 0;
    const auto law = [&](auto& source, std::size_t) -> contact::Law {
      const double k = std::pow(10, decade(source));
      if (ratio == 0) return contact::Linear{k};
      return contact::Viscoelastic{.stiffness = k, .damping = ratio * k, .exponent = 1};
    };
    BOOST_TEST_CONTEXT("network " << i)
    agrees_with_cvode(test::random_network(random, law), 1e-8, {.flow = flow::Kind::modal});
  }
}

BOOST_AUTO_TEST_CASE(redundant_contacts_keep_their_stress) {
  for (const double ratio : {0.0, 0.2})
    BOOST_TEST_CONTEXT("c/k " << ratio) agrees_with_cvode(beam_on_three_feet(ratio), 1e-10);
}

// A lever of ratio 2 makes it a network and no row; the walls never let go.
BOOST_AUTO_TEST_CASE(walls_that_come_closer_press_at_a_steady_rate) {
  const model::Network press{.mass = {infinity, 1, infinity},
                             .direction = {{{0, -1}, {1, 2}}, {{1, -2}, {2, 1}}},
                             .law = {contact::Linear{1}, contact::Linear{3}},
                             .gap = {0, 0},
                             .velocity = {1, 0.3, -0.5}};
  const double time = 7;
  const auto run = simulate(press, {.accuracy = 1e-12, .max_time = time});
  BOOST_TEST((run.ending == hybrid::Ending::time_limit));
  // Springs in series share one force, k₁ (1 − 2v) = k₂ (2v + 1/2); about that v the body swings at ω² = 4
  // (k₁ + k₂).
  const double straight = -1.0 / 16, v = straight + (0.3 - straight) * std::cos(4 * time);
  BOOST_TEST(run.velocity[1] == v, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(masses_that_are_coupled_have_the_same_modes) {
  auto network = beam_on_three_feet(0);
  // The same beam seen from its left foot: v = heave − 0.5 spin.
  network.mass = {2, 1, 1, 0.3 + 2 * 0.25};
  network.direction = {{{0, 1}}, {{0, 1}, {1, 0.6}}, {{0, 1}, {1, 1}}};
  network.velocity = {-1.1, 0.2};
  const auto seen = simulate(network, {.accuracy = 1e-12}), beam = simulate(beam_on_three_feet(0));
  BOOST_TEST(uses(seen, "modal"));
  BOOST_TEST(difference(impulses_of(seen), impulses_of(beam)) < 1e-13);
  BOOST_TEST(difference(seen.velocity, {beam.velocity[0] - 0.5 * beam.velocity[1], beam.velocity[1]}) <
             1e-13);
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_pulled_apart_holds_nothing) {
  const auto run = simulate(test::with_law(test::one_on_two(), contact::Linear{1}), {.accuracy = 1e-12});
  BOOST_TEST(uses(run, "modal"));
  BOOST_TEST(run.velocity[0] == -0.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(run.velocity[2] == run.velocity[4]);
  BOOST_TEST(run.velocity[3] == -run.velocity[5]);
  BOOST_TEST(run.contacts[2].periods.empty());
  BOOST_TEST(run.contacts[2].impulse == 0);
}

BOOST_AUTO_TEST_CASE(a_stiffness_ratio_of_1e10_costs_no_digits) {
  auto network = beam_on_three_feet(0);
  network.law[1] = contact::Linear{1e10};
  const auto run = simulate(network, {.accuracy = 1e-12});
  BOOST_TEST(uses(run, "modal"));
  BOOST_TEST((run.ending == hybrid::Ending::separated));
  BOOST_TEST(std::abs(run.energy.residual) < 1e-12 * run.energy.initial);
}

// Where a mode is so slow that it hardly moves, what closed contacts push an open one to is a difference of
// large ways.
BOOST_AUTO_TEST_CASE(an_open_contact_beside_a_slow_mode_is_where_it_is) {
  const auto along = [](double a, double b, double c, double d) {
    return ContactDirection{{0, a}, {1, b}, {2, c}, {3, d}};
  };
  const model::Network network{
      .mass = {2.08, 2.087, 0.265, 989.2},
      .direction = {along(-0.574, -0.076, -1.318, -1.238), along(-0.279, 0.28, 0.533, 0.799),
                    along(0.003, 0.597, -2.97, 0.391), along(-1.326, 0.045, -0.896, -1.326),
                    along(0.829, -0.279, 0.882, -0.559), along(-0.413, 0.16, 0.358, -0.288)},
      .law = {contact::Linear{192.5}, contact::Linear{4679}, contact::Linear{140.6}, contact::Linear{0.905},
              contact::Linear{0.94}, contact::Linear{41.7}},
      .gap = {0, 0, 0, 0.0226, 0, 0.23},
      .velocity = {1.603, -0.994, -0.103, 0.16}};
  const auto gaps = [&](flow::Kind flow) {
    return simulate(network, {.accuracy = 1e-12, .max_time = 0.05, .flow = flow}).gap;
  };
  BOOST_TEST(difference(gaps(flow::Kind::modal), gaps(flow::Kind::taylor)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_linear_rack_is_broken_with_closed_balances) {
  const auto network = test::with_law(test::rack(5, 0), contact::Linear{1});
  const auto run = simulate(network, {.accuracy = 1e-12});
  BOOST_TEST(uses(run, "modal"));
  BOOST_TEST((run.ending == hybrid::Ending::separated), run.message);
  BOOST_TEST(std::abs(run.energy.residual) < 1e-12 * run.energy.initial);
}
