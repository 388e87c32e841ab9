// A law that no flow but CVODE can follow gives what the same law gives as a power law.
#define BOOST_TEST_MODULE laws of ones own
#include <boost/test/unit_test.hpp>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/network/network_balance.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/custom_power_law.hpp"
#include "support/networks.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// Runs go at 1e-10; errors of two runs and of what happens in between add up.
constexpr double allowed = 1e-8;
const hybrid::Options options{.accuracy = 1e-10};

const contact::PowerLaw hertz = contact::Hertz{1}, damped{.stiffness = 1, .damping = 0.4, .exponent = 1.5},
                        kelvin_voigt{.stiffness = 2, .damping = 0.3, .exponent = 1};

model::Chain with_custom_laws(model::Chain chain) {
  for (auto& law : chain.law) law = custom(std::get<contact::PowerLaw>(law));
  return chain;
}

template <class Impact>
void expect_general_flows_only(const Impact& impact) {
  for (const auto& use : impact.flows)
    BOOST_TEST((use.name == "ballistic" || use.name.starts_with("cvode")), use.name);
}

void expect_the_same(const model::Chain& chain) {
  const auto expected = impact::simulate(chain, options);
  const auto found = impact::simulate(with_custom_laws(chain), options);
  BOOST_TEST((found.ending == expected.ending), found.message);
  BOOST_TEST(difference(found.velocity, expected.velocity) < allowed);
  BOOST_TEST(std::abs(found.energy.dissipated - expected.energy.dissipated) < allowed);
  BOOST_TEST(std::abs(found.energy.residual) < allowed);
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    BOOST_TEST(found.contacts[j].periods.size() == expected.contacts[j].periods.size());
    BOOST_TEST(std::abs(found.contacts[j].impulse - expected.contacts[j].impulse) < allowed);
    BOOST_TEST(std::abs(found.contacts[j].peak_force - expected.contacts[j].peak_force) < allowed);
  }
  expect_general_flows_only(found);
}

}  // namespace

BOOST_AUTO_TEST_CASE(chains_of_any_law) {
  expect_the_same({.mass = {1, 1, 1}, .law = {hertz, hertz}, .gap = {0, 0}, .velocity = {1, 0, 0}});
  expect_the_same({.mass = {1, 2, 3}, .law = {damped, hertz}, .gap = {0, 0.1}, .velocity = {1, 0, -0.5}});
  expect_the_same(
      {.mass = {infinity, 1, 1}, .law = {damped, kelvin_voigt}, .gap = {0, 0}, .velocity = {0, 0, -1}});
  expect_the_same({.mass = {1, 1, 1},
                   .law = {damped, damped},
                   .gap = {-0.1, 0},
                   .velocity = {-1, 0, 0},
                   .precompressed = true});
}

BOOST_AUTO_TEST_CASE(units_do_not_matter) {
  expect_the_same({.mass = {1e-9, 3e-9}, .law = {contact::Hertz{1e9}}, .gap = {1e-6}, .velocity = {1e-3, 0}});
  const model::Chain steel{
      .mass = {0.03, 0.05}, .law = {contact::PowerLaw{9.5e9, 2e4, 1.5}}, .gap = {0}, .velocity = {1, 0}};
  const auto expected = impact::simulate(steel, options);
  const auto found = impact::simulate(with_custom_laws(steel), options);
  BOOST_TEST(std::abs(found.time / expected.time - 1) < allowed);
  BOOST_TEST(std::abs(found.contacts[0].peak_indentation / expected.contacts[0].peak_indentation - 1) <
             allowed);
}

BOOST_AUTO_TEST_CASE(a_ball_that_rests_on_a_wall_under_gravity) {
  model::Chain chain{.mass = {infinity, 1}, .law = {hertz}, .gap = {0}, .velocity = {0, 0}, .gravity = 1};
  auto limited = options;
  limited.max_time = 3;
  const auto expected = impact::simulate(chain, limited),
             found = impact::simulate(with_custom_laws(chain), limited);
  BOOST_TEST(std::abs(found.gap[0] - expected.gap[0]) < allowed);
  BOOST_TEST(difference(found.velocity, expected.velocity) < allowed);
}

BOOST_AUTO_TEST_CASE(long_chains_of_any_law) {
  model::Chain chain;
  chain.mass.assign(60, 1);
  chain.velocity.assign(60, 0);
  chain.velocity[0] = 1;
  chain.gap.assign(59, 0);
  chain.law.assign(59, hertz);
  const auto expected = impact::simulate(chain, options);
  const auto found = impact::simulate(with_custom_laws(chain), options);
  BOOST_TEST(difference(found.velocity, expected.velocity) < allowed);
  expect_general_flows_only(found);
}

BOOST_AUTO_TEST_CASE(one_solver_takes_chains_of_any_law_in_turn) {
  const model::Chain power{.mass = {1, 1, 1}, .law = {hertz, damped}, .gap = {0, 0}, .velocity = {1, 0, 0}};
  impact::ChainSolver solver;
  for (const auto& flow : {std::optional<flow::Kind>{}, std::optional{flow::Kind::taylor}})
    for (const auto& chain : {power, with_custom_laws(power), power}) {
      const auto& impact = solver.solve(chain, {.accuracy = 1e-10, .flow = flow});
      BOOST_TEST(difference(impact.velocity, impact::simulate(power, options).velocity) < allowed);
    }
}

BOOST_AUTO_TEST_CASE(networks_of_any_law) {
  auto network = one_on_two();
  const auto expected = impact::simulate(network, options);
  for (auto& law : network.law) law = custom(std::get<contact::PowerLaw>(law));
  const auto found = impact::simulate(network, options);
  BOOST_TEST(difference(found.velocity, expected.velocity) < allowed);
  expect_general_flows_only(found);
}

BOOST_AUTO_TEST_CASE(the_rest_of_a_chain_is_followed_by_its_own_flows) {
  const model::Chain chain{.mass = {1, 1, 1}, .law = {hertz, hertz}, .gap = {0, 1}, .velocity = {1, 0, 0}};
  auto mixed = chain;
  mixed.law[1] = custom(hertz);
  const auto found = impact::simulate(mixed, options);
  BOOST_TEST(difference(found.velocity, impact::simulate(chain, options).velocity) < allowed);
  const auto followed_by = [&](std::string_view name) {
    return std::any_of(found.flows.begin(), found.flows.end(),
                       [&](const auto& use) { return use.name == name; });
  };
  BOOST_TEST(followed_by("pair"));
  BOOST_TEST(followed_by("cvode-adams"));
}

BOOST_AUTO_TEST_CASE(a_contact_without_a_law_is_refused) {
  BOOST_CHECK_THROW(impact::simulate(model::Chain{
                        .mass = {1, 1}, .law = {contact::SharedLaw()}, .gap = {0}, .velocity = {1, 0}}),
                    InvalidParameter);
}
