// Undamped impacts do not depend on how stiff, heavy or fast their bodies are [Acary 2003, Prop. 2.1], so the
// right answer is known at every scale: it is found, or the scene is refused by name.
#define BOOST_TEST_MODULE model_representable
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/model/representable.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using impact::ChainSolver;
using test::Numbers;

namespace {

struct Sizes {
  double mass, stiffness, speed;
};

const std::vector<double> laws = {1, 1.5, 2.5};  // exponents

contact::Law law_of(double exponent, double stiffness) {
  if (exponent == 1) return contact::Linear{stiffness};
  if (exponent == 1.5) return contact::Hertz{stiffness};
  return contact::Viscoelastic{.stiffness = stiffness, .damping = 0, .exponent = exponent};
}

/// A row of three, the middle one lighter, that a fast ball strikes.
model::Chain triplet(double exponent, const Sizes& sizes) {
  const auto law = law_of(exponent, sizes.stiffness);
  return {.mass = {sizes.mass, 0.5 * sizes.mass, sizes.mass},
          .law = {law, law},
          .gap = {0, 0},
          .velocity = {sizes.speed, 0, -0.25 * sizes.speed}};
}

/// Found, refused, or neither.
struct Tally {
  int found = 0, refused = 0;

  template <class Solve>
  void judge(const Numbers& expected, double speed, const Solve& solve) try {
    const auto impact = solve();
    BOOST_TEST((impact.ending == hybrid::Ending::separated), name(impact.ending) << ": " << impact.message);
    BOOST_TEST(std::isfinite(impact.time));
    for (std::size_t i = 0; i < expected.size(); ++i)
      BOOST_TEST(std::abs(impact.velocity[i] / speed - expected[i]) < 1e-9);
    ++found;
  } catch (const model::Unrepresentable& refusal) {
    BOOST_TEST(refusal.fault.code == fault::unrepresentable.code);
    ++refused;
  }
};

const std::vector<double> decades = {-300, -200, -162, -150, -100, -50, -12, 0,
                                     12,   50,   100,  150,  154,  200, 300};

/// `visit` for powers of ten.
template <class Visit>
void for_sizes(Visit&& visit) {
  for (const double speed : decades)
    for (const double mass : {-300, -100, -30, 0, 30, 100, 300})
      for (const double stiffness : {-300, -100, 0, 100, 300})
        visit(Sizes{std::pow(10, mass), std::pow(10, stiffness), std::pow(10, speed)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(chains_of_any_size_are_right_or_refused) {
  ChainSolver solver;
  for (const double exponent : laws) {
    Tally full, brief;
    const auto expected = impact::simulate(triplet(exponent, {1, 1, 1})).velocity;
    for_sizes([&](const Sizes& sizes) {
      const auto chain = triplet(exponent, sizes);
      BOOST_TEST_CONTEXT("n " << exponent << ", m " << sizes.mass << ", k " << sizes.stiffness << ", v "
                              << sizes.speed) {
        full.judge(expected, sizes.speed, [&] {
          const auto impact = impact::simulate(chain);
          for (const double number : {impact.energy.initial, impact.energy.final, impact.energy.residual,
                                      impact.contacts[0].peak_force, impact.contacts[0].impulse})
            BOOST_TEST(std::isfinite(number));
          BOOST_TEST(impact.energy.initial > 0);
          return impact;
        });
        brief.judge(expected, sizes.speed, [&] { return solver.solve(chain); });
      }
    });
    BOOST_TEST(full.found == brief.found);
    BOOST_TEST(full.found > 100);
    BOOST_TEST(full.refused > 100);
  }
}

BOOST_AUTO_TEST_CASE(speeds_alone_are_carried_over_280_decades) {
  for (const double exponent : laws) {
    const auto expected = impact::simulate(triplet(exponent, {1, 1, 1})).velocity;
    for (int decade = -140; decade <= 140; decade += 20) {
      Tally tally;
      const double speed = std::pow(10, decade);
      tally.judge(expected, speed, [&] { return impact::simulate(triplet(exponent, {1, 1, speed})); });
      BOOST_TEST(tally.found == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(networks_of_any_size_are_right_or_refused) {
  for (const double exponent : laws) {
    Tally tally;
    const auto expected = impact::simulate(triplet(exponent, {1, 1, 1})).velocity;
    for_sizes([&](const Sizes& sizes) {
      const auto network = model::as_network(triplet(exponent, sizes));
      BOOST_TEST_CONTEXT("n " << exponent << ", m " << sizes.mass << ", k " << sizes.stiffness << ", v "
                              << sizes.speed)
      tally.judge(expected, sizes.speed, [&] { return impact::simulate(network); });
    });
    BOOST_TEST(tally.found > 100);
    BOOST_TEST(tally.refused > 100);
  }
}

// Without damping and adhesion a sphere leaves as fast as it came.
BOOST_AUTO_TEST_CASE(spheres_of_any_size_are_right_or_refused) {
  int found = 0, refused = 0;
  for_sizes([&](const Sizes& sizes) {
    model::Microbody body;
    body.velocity = {-sizes.speed, 0, 0};
    body.body = {.mass = sizes.mass,
                 .inertia = {0.4 * sizes.mass, 0.4 * sizes.mass, 0.4 * sizes.mass},
                 .tips = {{.centre = {}, .radius = 1}}};
    body.law = {{.stiffness = sizes.stiffness}};
    try {
      const auto impact = impact::simulate(body);
      BOOST_TEST((impact.ending == hybrid::Ending::separated));
      BOOST_TEST(std::abs(impact.final.velocity.e1 / sizes.speed - 1) < 1e-9);
      BOOST_TEST(std::abs(impact::MicrobodySolver().solve(body).velocity.e1 / sizes.speed - 1) < 1e-9);
      ++found;
    } catch (const model::Unrepresentable&) {
      BOOST_CHECK_THROW(impact::MicrobodySolver().solve(body), model::Unrepresentable);
      ++refused;
    }
  });
  BOOST_TEST(found > 100);
  BOOST_TEST(refused > 100);
}

// With a gap larger than any indentation the collisions are those of pairs, one after the other.
BOOST_AUTO_TEST_CASE(gaps_of_any_size_are_right_or_refused) {
  for (const int decade : {-300, -160, -30, 3, 30, 160, 280, 300}) {
    const double gap = std::pow(10, decade);
    auto chain = test::equal_chain(3);
    const auto touching = impact::simulate(chain).velocity;
    chain.gap = {0, gap};
    Tally tally;
    tally.judge(gap > 1 ? Numbers{0, 0, 1} : touching, 1, [&] { return impact::simulate(chain); });
    BOOST_TEST(tally.found == (decade < 290 ? 1 : 0));
  }
}

// Two balls of any ratio of masses: v⁺ of elastic bodies.
BOOST_AUTO_TEST_CASE(ratios_of_masses_are_right_or_refused) {
  Tally tally;
  for (int decade = -300; decade <= 300; decade += 20) {
    const double ratio = std::pow(10, decade);
    const model::Chain pair{.mass = {1, ratio}, .law = {contact::Hertz{1}}, .gap = {0}, .velocity = {1, 0}};
    BOOST_TEST_CONTEXT("ratio " << ratio)
    tally.judge({(1 - ratio) / (1 + ratio), 2 / (1 + ratio)}, 1, [&] { return impact::simulate(pair); });
  }
  BOOST_TEST(tally.found >= 29);
}

BOOST_AUTO_TEST_CASE(the_likeliest_reason_is_named) {
  const auto key = [](model::Chain chain) {
    try {
      impact::simulate(chain);
    } catch (const model::Unrepresentable& refusal) {
      BOOST_TEST(std::string(refusal.what()).find(refusal.reason.key) != std::string::npos);
      return std::string(refusal.reason.key);
    }
    return std::string("nothing");
  };
  auto chain = test::equal_chain(3);
  BOOST_TEST(key(chain) == "nothing");
  chain.velocity[0] = 1e-163;
  BOOST_TEST(key(chain) == "velocity");
  chain.velocity[0] = 1e155;
  BOOST_TEST(key(chain) == "velocity");
  chain.velocity[0] = 1e10;
  chain.mass[2] = 1e295;
  BOOST_TEST(key(chain) == "mass");
  chain.mass[2] = 1;
  chain.gravity = 1e300;
  BOOST_TEST(key(chain) == "gravity");
  chain = test::equal_chain(3);
  chain.precompressed = true;
  chain.velocity[0] = 0;
  chain.gap[1] = -1e-200;
  BOOST_TEST(key(chain) == "gap");
}

// Series and steps of integrators know nothing below rounding; SUNDIALS gave up on them.
BOOST_AUTO_TEST_CASE(drives_that_turn_too_fast_are_refused_by_every_solver) {
  auto chain = test::equal_chain(3);
  chain.mass[0] = infinity;
  chain.velocity[0] = 0;
  const hybrid::Options options{.max_time = 1e-12};
  for (const double frequency : {1.0, 1e12, 1e17, 1e100, 1e300}) {
    chain.drive = {{.direction = {{0, 1.0}}, .signal = model::sine(1, frequency, 0)}};
    const auto refused = [&](const auto& solve) {
      try {
        return solve(), false;
      } catch (const model::Unrepresentable& refusal) {
        return refusal.reason.key == "frequency" && refusal.reason.drive == 0;
      }
    };
    BOOST_TEST_CONTEXT("frequency " << frequency) {
      BOOST_TEST(refused([&] { impact::simulate(chain, options); }) == (frequency > 1e15));
      BOOST_TEST(refused([&] { ChainSolver().solve(chain, options); }) == (frequency > 1e15));
      BOOST_TEST(refused([&] { impact::simulate(model::as_network(chain), options); }) == (frequency > 1e15));
    }
  }
}

// A wave's forerunner is slower than anything; beside a ball that moves it is rest.
BOOST_AUTO_TEST_CASE(a_tiny_speed_beside_others_is_no_reason) {
  auto chain = test::equal_chain(3);
  const auto expected = impact::simulate(chain).velocity;
  chain.velocity[2] = 1e-300;
  BOOST_TEST(test::difference(impact::simulate(chain).velocity, expected) < 1e-10);
}
