// Contacts that yield or adhere, followed in closed form while they are alone and by series among others,
// beside the same rows by CVODE.
#define BOOST_TEST_MODULE property branched pairs
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "mariotte/contact/dmt.hpp"
#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/named_laws.hpp"
#include "mariotte/contact/stated_law.hpp"
#include "mariotte/contact/thornton.hpp"
#include "mariotte/contact/thornton_ning.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/networks.hpp"

using namespace mariotte;

namespace {

contact::Law random_law(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  switch (std::uniform_int_distribution(0, 3)(random)) {
    case 0:
      return contact::state(contact::WaltonBraun(uniform(1, 2), uniform(2, 9)));
    case 1:
      return contact::Hertz(uniform(1, 4));
    default:  // yields at about a third of what it can meet, or not at all
      return contact::state(contact::Thornton(1, uniform(0.5, 2), uniform(0.05, 0.6)));
  }
}

/// Few balls far apart: most of their contacts are alone.
model::Chain random_row(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  model::Chain chain;
  const int balls = std::uniform_int_distribution(2, 5)(random);
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(uniform(0.3, 3));
    chain.velocity.push_back(uniform(-1, 1));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(uniform(0, 1) < 0.3 ? 0 : uniform(0.1, 2));
    chain.law.push_back(random_law(random));
  }
  if (uniform(0, 1) < 0.3) {
    chain.mass.back() = infinity;
    chain.velocity.back() = 0;
  }
  return chain;
}

/// Balls that touch or nearly do, struck from both ends: many push at a time, some with a damper.
model::Chain crowded_row(std::mt19937_64& random) {
  auto chain = random_row(random);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  chain.mass.push_back(uniform(0.3, 3));
  chain.velocity.push_back(-uniform(0, 1));
  chain.law.push_back(random_law(random));
  chain.gap.push_back(0);
  chain.mass[0] = 1;
  chain.velocity[0] = 1;
  for (auto& gap : chain.gap) gap = uniform(0, 1) < 0.5 ? 0 : uniform(0, 0.3);
  if (uniform(0, 1) < 0.3)
    chain.law.back() = contact::Viscoelastic{.stiffness = 2, .damping = uniform(0.01, 0.4), .exponent = 1.5};
  return chain;
}

Index phases_of(const impact::ContactImpact& impact, const char* flow) {
  for (const auto& use : impact.flows)
    if (use.name == flow) return use.phases;
  return 0;
}

}  // namespace

/// Same events, velocities, losses and peaks; how often contacts yield.
std::size_t compare(const model::Chain& chain, const impact::ChainImpact& own,
                    const impact::ChainImpact& other, int n) {
  std::size_t yields = 0;
  BOOST_TEST((own.ending == other.ending), "row " << n << ": " << own.message);
  BOOST_TEST_REQUIRE(own.events.size() == other.events.size(), "row " << n);
  for (std::size_t i = 0; i < own.events.size(); ++i) {
    const auto &one = own.events[i], &same = other.events[i];
    BOOST_TEST((one.open == same.open && one.close == same.close), "row " << n);
    BOOST_TEST((one.yield == same.yield && one.unload == same.unload), "row " << n);
    yields += one.yield.size();
  }
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    BOOST_TEST(std::abs(own.velocity[i] - other.velocity[i]) < 1e-10,
               "row " << n << ", ball " << i << ": " << own.velocity[i] << ", " << other.velocity[i]);
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    const auto &one = own.contacts[j], &same = other.contacts[j];
    BOOST_TEST(std::abs(one.plastic - same.plastic) < 1e-10);
    BOOST_TEST(std::abs(one.permanent_indentation - same.permanent_indentation) < 1e-10);
    BOOST_TEST(std::abs(one.peak_force - same.peak_force) < 1e-9);
  }
  return yields;
}

BOOST_AUTO_TEST_CASE(closed_forms_of_branches_agree_with_cvode) {
  std::mt19937_64 random(1986);
  Index closed_forms = 0;
  std::size_t yields = 0;
  for (int n = 0; n < 400; ++n) {
    const auto chain = random_row(random);
    const auto own = impact::simulate(chain, {.accuracy = 1e-12});
    const auto other = impact::simulate(chain, {.accuracy = 1e-12, .flow = flow::Kind::cvode_adams});
    closed_forms += phases_of(own, "pair");
    yields += compare(chain, own, other, n);
    const auto network = impact::simulate(model::as_network(chain), {.accuracy = 1e-12});
    for (std::size_t i = 0; i < chain.mass.size(); ++i)
      BOOST_TEST(std::abs(own.velocity[i] - network.velocity[i]) < 1e-10, "row " << n);
  }
  BOOST_TEST(closed_forms > 1000);
  BOOST_TEST(yields > 200u);
}

BOOST_AUTO_TEST_CASE(series_of_branches_agree_with_cvode) {
  std::mt19937_64 random(1997);
  Index series = 0;
  std::size_t yields = 0;
  for (int n = 0; n < 150; ++n) {
    const auto chain = crowded_row(random);
    const auto own = impact::simulate(chain, {.accuracy = 1e-12});
    const auto other = impact::simulate(chain, {.accuracy = 1e-12, .flow = flow::Kind::cvode_adams});
    series += phases_of(own, "taylor");
    BOOST_TEST(phases_of(own, "cvode-adams") == 0, "row " << n);
    yields += compare(chain, own, other, n);
    const auto islands = impact::simulate(chain, {.accuracy = 1e-12, .islands = hybrid::Islands::always});
    for (std::size_t i = 0; i < chain.mass.size(); ++i)
      BOOST_TEST(std::abs(own.velocity[i] - islands.velocity[i]) < 1e-10, "row " << n);
  }
  BOOST_TEST(series > 1000);
  BOOST_TEST(yields > 200u);
}

// Rows of dampers that may pull until their indentation ends.
BOOST_AUTO_TEST_CASE(series_of_dampers_that_end_with_the_indentation_agree_with_cvode) {
  std::mt19937_64 random(2007);
  Index series = 0;
  for (int n = 0; n < 100; ++n) {
    auto chain = crowded_row(random);
    for (auto& law : chain.law) {
      const double damping = std::uniform_real_distribution(0.02, 0.6)(random);
      const contact::Law kinds[] = {contact::Viscoelastic{.stiffness = 2, .damping = damping, .exponent = 1},
                                    contact::Viscoelastic{.stiffness = 2, .damping = damping},
                                    std::make_shared<contact::HuntCrossley>(2, damping),
                                    std::make_shared<contact::Tsuji>(2, damping)};
      law = contact::uncut(kinds[n % 4]);
    }
    const auto own = impact::simulate(chain, {.accuracy = 1e-12});
    const auto other = impact::simulate(chain, {.accuracy = 1e-12, .flow = flow::Kind::cvode_adams});
    series += phases_of(own, "taylor");
    BOOST_TEST(phases_of(own, "cvode-adams") == 0, "row " << n);
    compare(chain, own, other, n);
  }
  BOOST_TEST(series > 300);
}

/// A little slower or faster than what adhesion holds, so that some contacts hold for a while.
model::Chain sticky_row(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  model::Chain chain;
  const int balls = std::uniform_int_distribution(2, 5)(random);
  const bool yields = uniform(0, 1) < 0.5, hard = uniform(0, 1) < 0.3;
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(uniform(0.5, 2));
    chain.velocity.push_back(1 - 2.0 * i / (balls - 1) + uniform(-0.2, 0.2));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(uniform(0.01, 0.3));
    const double radius = uniform(0.5, 2), work = uniform(0.0005, 0.01);
    if (hard)
      chain.law.push_back(contact::state(contact::Dmt(1, radius, work, j % 2 * uniform(0, 0.1))));
    else
      chain.law.push_back(yields ? contact::state(contact::ThorntonNing(1, radius, uniform(0.3, 0.6), work))
                                 : contact::state(contact::Jkr(1, radius, work, uniform(0, 0.05))));
  }
  return chain;
}

// Until a time at which what is bound rings, too.
BOOST_AUTO_TEST_CASE(series_of_adhesive_branches_agree_with_cvode) {
  std::mt19937_64 random(1971);
  Index series = 0;
  std::size_t yields = 0;
  for (int n = 0; n < 100; ++n) {
    const auto chain = sticky_row(random);
    const auto own = impact::simulate(chain, {.accuracy = 1e-11, .max_time = 12});
    const auto other =
        impact::simulate(chain, {.accuracy = 1e-12, .max_time = 12, .flow = flow::Kind::cvode_adams});
    series += phases_of(own, "taylor");
    BOOST_TEST(phases_of(own, "cvode-adams") == 0, "row " << n);
    yields += compare(chain, own, other, n);
    for (std::size_t j = 0; j < chain.law.size(); ++j)
      BOOST_TEST(std::abs(own.contacts[j].adhesion - other.contacts[j].adhesion) < 1e-10);
  }
  BOOST_TEST(series > 500);
  BOOST_TEST(yields > 20u);
}

/// Alone and undamped: two phases without a step of an integrator, at the instants that CVODE finds, and the
/// restitution √(1 − v_c²/v²).
BOOST_AUTO_TEST_CASE(a_lone_adhesive_contact_has_a_closed_form) {
  for (const double work : {1e-4, 0.003, 0.02})
    for (const double speed : {1.001, 1.5, 20.0}) {
      const double lost = 7.0921959718639584 * std::cbrt(std::pow(work, 5) * std::pow(1.3, 4) / (0.7 * 0.7));
      const double least = std::sqrt(2 * lost * (1 + 0.5)), v = speed * least;
      const model::Chain chain{.mass = {1, 2},
                               .law = {contact::state(contact::Jkr(0.7, 1.3, work, 0))},
                               .gap = {0.2},
                               .velocity = {v, 0}};
      const auto own = impact::simulate(chain, {.accuracy = 1e-12});
      const auto other = impact::simulate(chain, {.accuracy = 1e-13, .flow = flow::Kind::cvode_adams});
      BOOST_TEST(phases_of(own, "pair") == 2);
      BOOST_TEST((own.velocity[1] - own.velocity[0]) / v == std::sqrt(1 - 1 / (speed * speed)),
                 boost::test_tools::tolerance(1e-8));
      BOOST_TEST(std::abs(own.velocity[0] - other.velocity[0]) < 1e-9 * v);
      BOOST_TEST_REQUIRE(own.events.size() == other.events.size());
      for (std::size_t i = 0; i < own.events.size(); ++i)
        BOOST_TEST(own.events[i].time == other.events[i].time, boost::test_tools::tolerance(1e-8));
    }
}

/// What is held rings between two turns, which is left to the series.
BOOST_AUTO_TEST_CASE(a_held_contact_rings_as_with_cvode) {
  for (const double speed : {0.01, 0.04, 0.1}) {
    const model::Chain chain{.mass = {1, 2},
                             .law = {contact::state(contact::Jkr(0.7, 1.3, 0.01, 0))},
                             .gap = {0.01},
                             .velocity = {speed, 0}};
    const auto own = impact::simulate(chain, {.accuracy = 1e-11, .max_time = 40});
    const auto other =
        impact::simulate(chain, {.accuracy = 1e-13, .max_time = 40, .flow = flow::Kind::cvode_adams});
    BOOST_TEST(phases_of(own, "pair") > 1);
    BOOST_TEST(phases_of(own, "taylor") > 1);
    for (std::size_t i = 0; i < chain.mass.size(); ++i)
      BOOST_TEST(std::abs(own.velocity[i] - other.velocity[i]) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(series_of_branches_in_networks_agree_with_cvode) {
  for (const double pressure : {0.08, 0.15, 0.4}) {
    const auto network =
        test::with_law(test::one_on_two(), contact::state(contact::Thornton(1, 0.5, pressure)));
    const auto own = impact::simulate(network, {.accuracy = 1e-12});
    const auto other = impact::simulate(network, {.accuracy = 1e-12, .flow = flow::Kind::cvode_adams});
    BOOST_TEST(own.contacts[0].plastic > 0);
    BOOST_TEST(phases_of(own, "cvode-adams") == 0);
    for (std::size_t i = 0; i < own.velocity.size(); ++i)
      BOOST_TEST(std::abs(own.velocity[i] - other.velocity[i]) < 1e-10);
  }
}

/// A contact that touches at rest yields long before its own step ends, at loose accuracy, too.
BOOST_AUTO_TEST_CASE(what_touches_yields_on_time) {
  const auto thornton = [](double modulus, double radius, double pressure) {
    return contact::state(contact::Thornton(modulus, radius, pressure));
  };
  const model::Chain chain{.mass = {1, 1, 1, 1, 1},
                           .law = {thornton(0.5, 1.2, 0.11), contact::state(contact::WaltonBraun(0.38, 10.7)),
                                   thornton(0.3, 2.04, 0.005), thornton(1.5, 2.9, 0.34)},
                           .gap = {0, 0, 0, 0},
                           .velocity = {1, 0, 0, 0, 0}};
  const auto loose = impact::simulate(chain, {.accuracy = 1e-6}),
             tight = impact::simulate(chain, {.accuracy = 1e-12});
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    BOOST_TEST(std::abs(loose.velocity[i] - tight.velocity[i]) < 1e-6);
}

/// √(k₁/k₂), to the last digits and in three phases without a step of an integrator.
BOOST_AUTO_TEST_CASE(a_pair_of_two_springs_takes_no_integration) {
  for (const double speed : {1e-3, 1.0, 30.0}) {
    const auto impact = impact::simulate(model::Chain{.mass = {1, 2},
                                                      .law = {contact::state(contact::WaltonBraun(3, 7))},
                                                      .gap = {0},
                                                      .velocity = {speed, 0}},
                                         {});
    BOOST_TEST((impact.velocity[1] - impact.velocity[0]) / speed == std::sqrt(3.0 / 7),
               boost::test_tools::tolerance(1e-14));
    BOOST_TEST(phases_of(impact, "cvode-adams") == 0);
    BOOST_TEST(phases_of(impact, "pair") == 2);
  }
}
