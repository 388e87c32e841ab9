#define BOOST_TEST_MODULE properties of random chains
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <functional>

#include "support/random_chains.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

constexpr hybrid::Options options{.accuracy = 1e-8};

struct Scene {
  model::Chain chain;
  impact::ChainImpact impact;
};

/// The same 1000 scenes for every property.
const std::vector<Scene>& scenes() {
  static const auto all = [] {
    std::mt19937_64 random(20031102);
    std::vector<Scene> made(1000);
    for (auto& [chain, impact] : made) {
      chain = random_chain(random);
      impact = impact::simulate(chain, options);
    }
    return made;
  }();
  return all;
}

void for_each_chain(const std::function<void(const model::Chain&, const impact::ChainImpact&)>& check) {
  for (std::size_t i = 0; i < scenes().size(); ++i)
    BOOST_TEST_CONTEXT("scene " << i) check(scenes()[i].chain, scenes()[i].impact);
}

double largest_speed(const model::Chain& chain) {
  double speed = 0;
  for (const double v : chain.velocity) speed = std::max(speed, std::abs(v));
  return speed;
}

/// Two runs of one physics agree to what was asked of each. Some of these scenes, with up to a hundred
/// events, blow up every error on the way; for them the error that a tighter run reveals is the measure.
void check_same(const model::Chain& chain, const impact::ChainImpact& impact, const Numbers& velocity) {
  const double apart = difference(velocity, impact.velocity) / largest_speed(chain);
  if (apart <= 2 * options.accuracy) return;
  BOOST_TEST(apart <= 100 * impact::estimate_accuracy(chain, options, impact));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_chain_ends_separated_and_in_order) {
  for_each_chain([](const auto& chain, const auto& impact) {
    BOOST_TEST((impact.ending == hybrid::Ending::separated));
    for (std::size_t i = 0; i + 1 < impact.velocity.size(); ++i)
      BOOST_TEST(impact.velocity[i + 1] - impact.velocity[i] > -options.accuracy * 2 * largest_speed(chain));
  });
}

BOOST_AUTO_TEST_CASE(momentum_is_kept_to_1e_minus_12) {
  for_each_chain([](const auto& chain, const auto& impact) {
    double size = 0;
    for (std::size_t i = 0; i < chain.mass.size(); ++i) size += chain.mass[i] * std::abs(chain.velocity[i]);
    BOOST_TEST(std::abs(impact.momentum.residual) <= 1e-12 * size);
  });
}

BOOST_AUTO_TEST_CASE(the_energy_balance_closes) {
  for_each_chain([](const auto&, const auto& impact) {
    BOOST_TEST(std::abs(impact.energy.residual) <= 100 * options.accuracy * impact.energy.initial);
  });
}

BOOST_AUTO_TEST_CASE(dissipation_is_never_negative_and_only_where_there_is_damping) {
  for_each_chain([](const auto& chain, const auto& impact) {
    for (std::size_t j = 0; j < chain.law.size(); ++j) {
      BOOST_TEST(impact.contacts[j].dissipated >= 0);
      if (contact::damping(chain.law[j]) == 0) BOOST_TEST(impact.contacts[j].dissipated == 0);
    }
    BOOST_TEST(impact.energy.final <= impact.energy.initial * (1 + 100 * options.accuracy));
  });
}

BOOST_AUTO_TEST_CASE(impulses_push_and_periods_alternate) {
  for_each_chain([](const auto& chain, const auto& impact) {
    for (const auto& contact : impact.contacts) {
      BOOST_TEST(contact.impulse >= -100 * options.accuracy * largest_speed(chain));
      double last = -1;
      for (const auto& period : contact.periods) {
        BOOST_TEST(period.start >= last);
        BOOST_TEST(*period.end >= period.start);
        last = *period.end;
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(the_mirror_image_is_the_mirror_image) {
  for_each_chain([](const auto& chain, const auto& impact) {
    auto mirrored = chain;
    for (auto* list : {&mirrored.mass, &mirrored.velocity, &mirrored.gap})
      std::reverse(list->begin(), list->end());
    std::reverse(mirrored.law.begin(), mirrored.law.end());
    for (double& v : mirrored.velocity) v = -v;
    auto velocity = impact::simulate(mirrored, options).velocity;
    std::reverse(velocity.begin(), velocity.end());
    for (double& v : velocity) v = -v;
    check_same(chain, impact, velocity);
  });
}

BOOST_AUTO_TEST_CASE(a_moving_observer_sees_the_same_impact) {
  for_each_chain([](const auto& chain, const auto& impact) {
    auto moving = chain;
    for (double& v : moving.velocity) v += 3;
    auto velocity = impact::simulate(moving, options).velocity;
    for (double& v : velocity) v -= 3;
    check_same(chain, impact, velocity);
  });
}

BOOST_AUTO_TEST_CASE(mass_and_time_scale_as_dimensions_say) {
  // m → λm, k → λk, c → λc: the same motion. t → τt: k → k/τ², c → c/τ, v → v/τ, the same path.
  for_each_chain([](const auto& chain, const auto& impact) {
    constexpr double lambda = 7, tau = 3;
    auto scaled = chain;
    for (double& m : scaled.mass) m *= lambda;
    for (double& v : scaled.velocity) v /= tau;
    for (auto& any : scaled.law) {
      auto& law = std::get<contact::PowerLaw>(any);
      law.stiffness *= lambda / (tau * tau);
      law.damping *= lambda / tau;
    }
    auto velocity = impact::simulate(scaled, options).velocity;
    for (double& v : velocity) v *= tau;
    check_same(chain, impact, velocity);
  });
}
