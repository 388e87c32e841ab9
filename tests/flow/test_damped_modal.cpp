#define BOOST_TEST_MODULE modal flow of damped contacts
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/model/chain/chain_system.hpp"
#include "support/linear_chains.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

/// Some of the contacts damped, lightly to heavily, and each by its own; walls at some ends.
model::Chain random_dampers(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  auto chain = random_springs(random);
  for (auto& law : chain.law) {
    const double stiffness = std::pow(10, uniform(-1, 1));
    law = uniform(0, 1) < 0.3 ? contact::Law(contact::Linear{stiffness})
                              : damper(stiffness, std::pow(10, uniform(-2, 1)) * std::sqrt(stiffness));
  }
  if (uniform(0, 1) < 0.3) {
    chain.mass.front() = infinity;
    chain.velocity.front() = 0;
  } else if (uniform(0, 1) < 0.3) {
    chain.mass.back() = infinity;
    chain.velocity.back() = -0.5;
  }
  return chain;
}

bool used(const impact::ChainImpact& impact, const std::string& flow) {
  return std::any_of(impact.flows.begin(), impact.flows.end(),
                     [&](const auto& use) { return use.name == flow; });
}

/// Velocities, impulses, losses and peaks of two runs.
void check_same(const impact::ChainImpact& a, const impact::ChainImpact& b, double allowed) {
  BOOST_TEST(difference(a.velocity, b.velocity) < allowed);
  BOOST_TEST(period_counts(a) == period_counts(b), boost::test_tools::per_element());
  for (std::size_t j = 0; j < a.contacts.size(); ++j) {
    const auto &left = a.contacts[j], &right = b.contacts[j];
    BOOST_TEST(std::abs(left.impulse - right.impulse) < 10 * allowed);
    BOOST_TEST(std::abs(left.dissipated - right.dissipated) < 10 * allowed);
    BOOST_TEST(std::abs(left.peak_force - right.peak_force) <= 10 * allowed * (1 + right.peak_force));
    BOOST_TEST(std::abs(left.peak_indentation - right.peak_indentation) <=
               10 * allowed * (1 + right.peak_indentation));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(damped_pairs_move_as_in_closed_form) {
  // Through critical damping, which is at √2, and far beyond it.
  for (const double c : {1e-6, 1e-3, 0.1, 1.0, 1.4, std::sqrt(2.0), 1.415, 2.0, 10.0, 1e3, 1e6}) {
    const auto chain = equal_masses({damper(1, c)}, {1, 0});
    const auto exact = impact::simulate(chain, {.flow = flow::Kind::pair});
    const auto modal = impact::simulate(chain, {.flow = flow::Kind::modal});
    BOOST_TEST_CONTEXT("damping " << c) {
      BOOST_TEST(used(modal, "modal"));
      check_same(modal, exact, 1e-13);
      BOOST_TEST(modal.time == exact.time, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(std::abs(modal.energy.residual) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(damped_references_are_met_to_1e_minus_13) {
  for (const auto& c : cases("viscoelastic.json")) {
    if (c.at("exponent") != 1.0 || !c.contains("final")) continue;
    BOOST_TEST_CONTEXT("damping " << c.at("damping")) {
      const auto law = viscoelastic(c);
      const auto impact = impact::simulate(equal_masses({law, law}, {1, 0, 0}));
      BOOST_TEST(difference(impact.velocity, c.at("final")) < 1e-13);
      BOOST_TEST(impact.time == c.at("time").get<double>(), boost::test_tools::tolerance(1e-12));
      BOOST_TEST(std::abs(*impact.energy.ratio_lab - c.at("energy_ratio").get<double>()) < 1e-13);
      BOOST_TEST(!used(impact, "cvode-adams"));
    }
  }
}

BOOST_AUTO_TEST_CASE(damped_triplets_are_followed_as_cvode_follows_them) {
  // Equal and different ratios c/k, critical for the first mode at (2, 2), one contact undamped.
  const double dampings[][2] = {{0.1, 0.1}, {2, 2},   {5, 5},  {0.1, 1}, {1, 0.1},
                                {0, 0.5},   {0.5, 0}, {3, 20}, {30, 2}};
  for (const auto& c : dampings)
    for (const double ratio : {0.1, 1.0, 10.0})
      for (const Numbers& v : {Numbers{1, 0, 0}, Numbers{1, 0, -0.5}, Numbers{1, 0.3, -1}}) {
        const auto law = [](double k, double damping) {
          return damping > 0 ? damper(k, damping) : contact::Law(contact::Linear{k});
        };
        const auto chain = equal_masses({law(1, c[0]), law(ratio, c[1] * ratio)}, v);
        const auto modal = impact::simulate(chain);
        BOOST_TEST_CONTEXT("damping " << c[0] << " " << c[1] << " ratio " << ratio << " velocity " << v[1]) {
          BOOST_TEST(!used(modal, "cvode-adams"));
          BOOST_TEST(std::abs(modal.energy.residual) < 1e-13);
          check_same(modal, impact::simulate(chain, {.accuracy = 1e-11, .flow = flow::Kind::cvode_adams}),
                     1e-9);
        }
      }
}

BOOST_AUTO_TEST_CASE(random_dampers_are_followed_as_cvode_follows_them) {
  std::mt19937_64 random(1673);
  for (int i = 0; i < 100; ++i) {
    const auto chain = random_dampers(random);
    const hybrid::Options to_end{.max_time = 50},
        by_cvode{.accuracy = 1e-9, .max_time = 50, .flow = flow::Kind::cvode_adams};
    const auto modal = impact::simulate(chain, to_end);
    const auto cvode = impact::simulate(chain, by_cvode);
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST((modal.ending == cvode.ending));
      BOOST_TEST(std::abs(modal.energy.residual) <
                 1e-11 * (modal.energy.initial + std::abs(modal.energy.work)));
      BOOST_TEST(std::abs(modal.momentum.residual) < 1e-12);
      const double wrong = impact::estimate_accuracy(chain, by_cvode, cvode);
      check_same(modal, cvode, std::max(1e-7, 100 * wrong));
    }
  }
}

BOOST_AUTO_TEST_CASE(damping_ratios_up_to_1e6_stay_exact) {
  // Damping so strong is a plastic impact: in the limit a contact takes all approach at once.
  for (const double c : {1e2, 1e4, 1e6})
    for (const auto& laws :
         {std::vector{damper(1, c), damper(1, c)}, std::vector{damper(1, c), damper(3, 2 * c)},
          std::vector{damper(1, c), contact::Law(contact::Linear{1})}}) {
      const auto chain = equal_masses(laws, {1, 0, 0});
      const auto impact = impact::simulate(chain);
      auto mirror = equal_masses({laws[1], laws[0]}, {0, 0, -1});
      auto mirrored = impact::simulate(mirror).velocity;
      std::reverse(mirrored.begin(), mirrored.end());
      for (double& v : mirrored) v = -v;
      BOOST_TEST_CONTEXT("damping " << c << " " << contact::damping(laws[1])) {
        BOOST_TEST(!used(impact, "cvode-bdf-dense"));
        BOOST_TEST(difference(impact.velocity, mirrored) < 1e-12);
        BOOST_TEST(std::abs(impact.energy.residual) < 1e-12);
        if (contact::damping(laws[1]) > 0)
          BOOST_TEST(difference(impact.velocity, {1.0 / 3, 1.0 / 3, 1.0 / 3}) < 2 / c);
        if (c <= 1e2)
          check_same(impact, impact::simulate(chain, {.accuracy = 1e-9, .flow = flow::Kind::cvode_bdf_dense}),
                     1e-6);
      }
    }
}

BOOST_AUTO_TEST_CASE(modes_that_meet_are_left_to_other_flows) {
  // One body between two walls: λ² + 4 λ + 4, from contacts of different c/k; and the same a little off.
  for (const double off : {0.0, 1e-10, 1e-6, 1e-2}) {
    const model::Chain chain{.mass = {infinity, 1, infinity},
                             .law = {damper(1, 3), damper(3, 1 + off)},
                             .gap = {-0.1, -0.1},
                             .velocity = {0, 0.01, 0},
                             .precompressed = true};
    const hybrid::Options short_while{.max_time = 0.05};
    const auto impact = impact::simulate(chain, short_while);
    BOOST_TEST_CONTEXT("off by " << off) {
      BOOST_TEST(used(impact, "modal") == (off > 1e-5));
      const auto cvode =
          impact::simulate(chain, {.accuracy = 1e-11, .max_time = 0.05, .flow = flow::Kind::cvode_adams});
      check_same(impact, cvode, 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(modes_whose_shapes_overflow_are_left_to_other_flows) {
  // Drawn at random. Rates over eight decades: one mode of the five contacts has no finite size.
  const contact::Law soft = damper(0.0520, 0.2258), weak = damper(7.036e-4, 5.886e-4),
                     hard = damper(14945.8, 0.9657);
  const model::Chain chain{.mass = std::vector(7, 1.0),
                           .law = {soft, weak, hard, hard, weak, soft},
                           .gap = {0, 0.4232, 0, 0, 0.4232, 0},
                           .velocity = {-0.8387, 0.4095, -0.1236, 0, 0.1236, -0.4095, 0.8387}};
  const auto impact = impact::simulate(chain);
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_TEST(used(impact, "modal"));
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-12);
  for (std::size_t i = 0; i < 7; ++i)
    BOOST_TEST(std::abs(impact.velocity[i] + impact.velocity[6 - i]) < 1e-9);
  check_same(impact, impact::simulate(chain, {.accuracy = 1e-9, .flow = flow::Kind::cvode_bdf_klu}), 1e-6);
}

BOOST_AUTO_TEST_CASE(modes_that_miss_the_state_are_left_to_other_flows) {
  // Drawn at random. By symmetry each stiff dashpot has a mode beside that of the other, equal to 1e-7.
  const contact::Law end = damper(0.6583, 0.0958), dashpot = damper(1.7065, 1908.4);
  const model::Chain chain{
      .mass = {1.0648, 1.1266, 1.01, 0.9033, 1.01, 1.1266, 1.0648},
      .law = {end, dashpot, contact::Linear{0.5511}, contact::Linear{0.5511}, dashpot, end},
      .gap = std::vector(6, 0.0),
      .velocity = {0.6874, 0.4345, 0.0587, 0, -0.0587, -0.4345, -0.6874}};
  const auto impact = impact::simulate(chain);
  BOOST_TEST((impact.ending == hybrid::Ending::separated));
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-9);
  for (std::size_t i = 0; i < 7; ++i)
    BOOST_TEST(std::abs(impact.velocity[i] + impact.velocity[6 - i]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(contacts_between_walls_have_a_part_that_does_not_vibrate) {
  for (const double c : {0.0, 0.3})
    for (const double speed : {0.0, -0.2}) {
      const auto law = [&](double k) { return c > 0 ? damper(k, c) : contact::Law(contact::Linear{k}); };
      const model::Chain chain{.mass = {infinity, 1, 2, infinity},
                               .law = {law(1), law(2), law(1)},
                               .gap = {-0.5, -0.3, -0.5},
                               .velocity = {0, 0.1, -0.1, speed},
                               .precompressed = true};
      const auto modal = impact::simulate(chain, {.max_time = 2, .flow = flow::Kind::modal});
      BOOST_TEST_CONTEXT("damping " << c << " speed " << speed) {
        BOOST_TEST(used(modal, "modal"));
        BOOST_TEST(std::abs(modal.energy.residual) < 1e-14);
        check_same(
            modal,
            impact::simulate(chain, {.accuracy = 1e-11, .max_time = 2, .flow = flow::Kind::cvode_adams}),
            1e-9);
      }
    }
}

BOOST_AUTO_TEST_CASE(loads_are_told_from_rounding_of_what_dampers_let_through) {
  // Balls come no faster than 10⁻⁶ of what their indentations could give without dampers: the second contact
  // lets go at 32.15 s, and would creep for 10¹⁰ s if its load were taken for rounding of that. The
  // velocities are those of the modes with sixty digits.
  const model::Chain chain{.mass = std::vector(4, 0.10615026037887426),
                           .law = {damper(5.4384269385026351e-13, 0.07755583243776068),
                                   damper(7.8087032074869552e-13, 0.33292190392908877),
                                   damper(3.6970035043702805e-11, 1.1641242712168227)},
                           .gap = {0, -0.00093372507335675974, -0.0017846929900590652},
                           .velocity = {0, 0, 0, 0},
                           .precompressed = true};
  const double expected[] = {-1.52645131756782e-14, -1.52645131755372e-14, -1.30744554206376e-14,
                             4.3603481771853e-14};
  for (const double accuracy : {1e-6, 1e-10, 1e-12}) {
    const auto impact = impact::simulate(chain, {.accuracy = accuracy});
    BOOST_TEST(impact.time == 32.1505501973758, boost::test_tools::tolerance(1e-7));
    for (std::size_t i = 0; i < 4; ++i)
      BOOST_TEST(impact.velocity[i] == expected[i], boost::test_tools::tolerance(1e-11));
  }
}

BOOST_AUTO_TEST_CASE(a_slack_contact_is_armed_again_when_a_neighbour_pushes) {
  // The third ball comes at the time at which the first contact has let go but is still indented.
  using contact::ContactMode;
  int armed = 0;
  for (double gap = 2; gap < 4; gap += 0.1) {
    auto chain = equal_masses({damper(1, 0.5), damper(2, 0.1)}, {1, 0, -1});
    chain.gap[1] = gap;
    model::ChainSystem system;
    system.reset(chain, 1e-10, false);
    hybrid::Workspace<model::ChainSystem> workspace;
    std::vector<double> start;
    initial_state(system.chain(), system.layout(), start);
    const auto& run = hybrid::simulate(system, start, {}, workspace);
    for (const auto& [time, change] : run.changes)
      armed += change.before == ContactMode::slack && change.after == ContactMode::closed;
    const auto modal = impact::simulate(chain);
    BOOST_TEST_CONTEXT("gap " << gap) {
      BOOST_TEST(!used(modal, "cvode-adams"));
      BOOST_TEST(std::abs(modal.energy.residual) < 1e-14);
      check_same(modal, impact::simulate(chain, {.accuracy = 1e-11, .flow = flow::Kind::cvode_adams}), 1e-9);
    }
  }
  BOOST_TEST(armed > 0);
}

// Loads of mirrored dampers change their signs at one instant and are rounding there, c ε v. Two such
// contacts went slack and gripped in turn without end.
BOOST_AUTO_TEST_CASE(loads_that_are_rounding_do_not_change_their_sign_in_turn) {
  const std::vector<contact::Law> law = {
      contact::Linear{2354028.5873244931}, damper(878814.6079233503, 127.53333886604662),
      damper(3169890.6351572792, 56008.720047182302), damper(991448.38025129191, 14.973173170125962)};
  model::Chain chain{
      .mass = {0.00016247415541529025, 0.0001244052456954487, 0.0001636812788058476, 0.00012637464892668664,
               0.0001482211226433521},
      .law = law,
      .gap = {0, 0.0035259335922904625, 0.0088943624550859753, 0.01335226006265231},
      .velocity = {-117.12068434229988, 78.152307482618539, -273.74573457249454, -794.92229968022036, 0}};
  for (int i = 3; i >= 0; --i) {
    chain.mass.push_back(chain.mass[i]);
    chain.law.push_back(law[i]);
    chain.gap.push_back(chain.gap[i]);
    chain.velocity.push_back(-chain.velocity[i]);
  }
  const auto best = impact::simulate(chain, {.accuracy = 1e-12});
  for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
    const auto impact = impact::simulate(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(difference(impact.velocity, best.velocity) < accuracy * 800);
  }
}
