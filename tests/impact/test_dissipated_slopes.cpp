// Slopes of the dissipated energy, which follow from impulses and approaches, are those of differences of
// runs.
#define BOOST_TEST_MODULE impact_dissipated_slopes
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"

using namespace mariotte;

namespace {

const impact::OutcomeSlopes* dissipated(const impact::Sensitivity& found) {
  const auto one = std::find_if(found.outcome.begin(), found.outcome.end(),
                                [](const auto& outcome) { return outcome.name == "dissipated"; });
  return one == found.outcome.end() ? nullptr : &*one;
}

template <class Model>
void expect_differences(const Model& model) {
  const auto by = impact::parameters(model);
  const auto found = impact::sensitivity(model, by, {.accuracy = 1e-10});
  const auto* own = dissipated(found);
  BOOST_TEST_REQUIRE(own != nullptr);
  const auto run = [](const Model& one) {
    return impact::simulate(one, {.accuracy = 1e-13}).energy.dissipated;
  };
  BOOST_TEST(std::abs(own->value.value() - run(model)) < 1e-10);
  for (std::size_t c = 0; c < by.size(); ++c) {
    if (by[c].value == 0) continue;  // of a contact that touches, or a ball that touches at rest
    const double step = 1e-3 * std::abs(by[c].value);
    const double expected = impact::stencil_slope(step, [&](std::size_t k) {
      return run(by[c].model(by[c].value + impact::stencil[k].offset * step));
    });
    BOOST_TEST(std::abs(own->slope[c].value() - expected) < 1e-8, by[c].name);
  }
}

const std::vector<contact::Law> laws = {contact::Viscoelastic{1, 0.3, 1.5},
                                        contact::Viscoelastic{2, 0.1, 1.3}, contact::Hertz{3}};

}  // namespace

BOOST_AUTO_TEST_CASE(of_a_chain) {
  expect_differences(
      model::Chain{.mass = {1, 1.2, 0.9, 2}, .law = laws, .gap = {0, 0.1, 0.2}, .velocity = {1, 0, 0, -0.3}});
}

BOOST_AUTO_TEST_CASE(of_a_chain_at_a_wall_that_moves) {
  expect_differences(model::Chain{
      .mass = {1, 1.2, 0.9, infinity}, .law = laws, .gap = {0, 0.1, 0.2}, .velocity = {1, 0, 0, -0.3}});
}

BOOST_AUTO_TEST_CASE(of_a_network_whose_contacts_stand_askew) {
  expect_differences(model::Network{
      .mass = {1, 1, 1.3, 1.3, 0.8, 0.8},
      .direction = {{{0, -0.8}, {1, -0.6}, {2, 0.8}, {3, 0.6}}, {{0, -0.8}, {1, 0.6}, {4, 0.8}, {5, -0.6}}},
      .law = {laws[0], laws[1]},
      .gap = {0.01, 0.02},
      .velocity = {1, 0.1, 0, 0, 0, 0}});
}

// Gravity works on what moves, contacts that start pressed store energy, and of elastic ones nothing is lost.
BOOST_AUTO_TEST_CASE(only_where_impulses_tell_it) {
  const model::Chain chain{.mass = {1, 2}, .law = {laws[0]}, .gap = {0}, .velocity = {1, 0}};
  const auto is_told = [](const model::Chain& one) {
    const auto found = impact::sensitivity(one, impact::parameters(one), {.accuracy = 1e-8, .max_time = 50});
    return dissipated(found) != nullptr;
  };
  BOOST_TEST(is_told(chain));
  auto falling = chain, pressed = chain, elastic = chain;
  falling.mass[1] = infinity;
  falling.gravity = 0.001;
  pressed.gap = {-0.1};
  pressed.precompressed = true;
  elastic.law = {contact::Hertz{1}};
  for (const auto& one : {falling, pressed, elastic}) BOOST_TEST(!is_told(one));
}
