#define BOOST_TEST_MODULE modal flow
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <new>
#include <random>

#include "mariotte/flow/flows.hpp"
#include "mariotte/model/chain/chain_system.hpp"
#include "support/linear_chains.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;

namespace {

long allocations = 0;

}  // namespace

// Not inlined, or the compiler takes each malloc and free for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

/// Closed form of the triplet struck by its first ball [Acary 2003, appendix B, corrected], contact 1 opening
/// first.
Numbers triplet_velocities(double ratio) {
  const double s = std::sqrt(ratio * ratio - ratio + 1), fast = std::sqrt(ratio + 1 + s),
               slow = std::sqrt(3 * ratio) / fast;
  const double gamma = ratio < 1 ? ratio - 1 - s : -ratio / (ratio - 1 + s), beta = -ratio / gamma;
  const auto x1 = [&](double t) {
    return (beta * std::sin(slow * t) / slow - gamma * std::sin(fast * t) / fast) / (2 * s);
  };
  double low = 1, high = 4;
  for (int i = 0; i < 200; ++i) (x1(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  const auto swing = [&](double w) {
    const double half = std::sin(0.5 * w * low);
    return 2 * half * half / (w * w);
  };
  const double X = (std::sin(slow * low) / slow - std::sin(fast * low) / fast) / (2 * s);
  const double D = (std::cos(slow * low) - std::cos(fast * low)) / (2 * s);
  const double W = std::sqrt(2 * ratio), angle = std::atan2(X * W, -D);
  const double p1 = (beta * swing(slow) - gamma * swing(fast)) / (2 * s);
  const double p2 = ratio * ((swing(slow) - swing(fast)) / (2 * s) + X * std::sin(angle) / W +
                             D * (1 - std::cos(angle)) / (W * W));
  return {1 - p1, p1 - p2, p2};
}

}  // namespace

BOOST_AUTO_TEST_CASE(triplets_agree_with_their_closed_form_at_any_stiffness_ratio) {
  // Where contact 1 opens first: ω₂/ω₁ below 2, and beyond for ratios below 1 always.
  for (const double ratio : {1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.9, 1.0, 1.5, 2.0, 2.2}) {
    const auto impact =
        impact::simulate(equal_masses({contact::Linear{1}, contact::Linear{ratio}}, {1, 0, 0}));
    BOOST_TEST_CONTEXT("ratio " << ratio)
    BOOST_TEST(difference(impact.velocity, triplet_velocities(ratio)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(all_linear_references_are_met_to_1e_minus_14) {
  for (const auto& c : cases("linear_triplets.json")) BOOST_TEST_CONTEXT("kappa " << c.at("kappa")) {
      const auto impact = impact::simulate(linear_triplet(c));
      BOOST_TEST(difference(impact.velocity, c.at("final")) < 1e-14);
      // The end of a stiff last contact hangs on a velocity difference that is small itself.
      const double close = c.at("kappa") > 1e4 ? 1e-10 : 1e-13;
      BOOST_TEST(impact.time == c.at("time").get<double>(), boost::test_tools::tolerance(close));
    }
  for (const auto& c : cases("triplets.json")) {
    if (c.at("law") != "linear") continue;
    BOOST_TEST_CONTEXT("kappa " << c.at("kappa") << " velocity " << c.at("velocity")) {
      const auto impact = impact::simulate(triplet(c));
      BOOST_TEST(difference(impact.velocity, c.at("final")) < 2e-14);
      BOOST_TEST(impact.contacts[0].periods.size() == c.at("periods")[0].size());
      BOOST_TEST(impact.contacts[1].periods.size() == c.at("periods")[1].size());
    }
  }
}

BOOST_AUTO_TEST_CASE(stiffness_ratios_up_to_1e10_stay_exact) {
  // In the limit the last two balls are one of mass 2 while in contact, then the stiff contact has a last
  // word; energy and momentum leave one number to check, and the mirrored chain must agree on it.
  for (const double ratio : {1e7, 1e8, 1e9, 1e10}) {
    const contact::Linear soft{1}, stiff{ratio};
    const auto impact = impact::simulate(equal_masses({soft, stiff}, {1, 0, 0}));
    auto mirrored = impact::simulate(equal_masses({stiff, soft}, {0, 0, -1})).velocity;
    std::reverse(mirrored.begin(), mirrored.end());
    for (double& v : mirrored) v = -v;
    BOOST_TEST_CONTEXT("ratio " << ratio) {
      BOOST_TEST(difference(impact.velocity, mirrored) < 1e-12);
      BOOST_TEST(std::abs(impact.velocity[0] + 1.0 / 3) < 2 / std::sqrt(ratio));
      BOOST_TEST(std::abs(impact.energy.residual) < 1e-12);
      BOOST_TEST(std::abs(impact.momentum.residual) < 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(random_springs_are_followed_as_cvode_follows_them) {
  std::mt19937_64 random(1738);
  for (int i = 0; i < 100; ++i) {
    const auto chain = random_springs(random);
    const auto exact = impact::simulate(chain);
    const auto cvode = impact::simulate(chain, {.accuracy = 1e-9, .flow = flow::Kind::cvode_adams});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST(std::abs(exact.energy.residual) < 1e-12 * exact.energy.initial);
      BOOST_TEST(period_counts(exact) == period_counts(cvode), boost::test_tools::per_element());
      if (difference(exact.velocity, cvode.velocity) > 1e-8)
        BOOST_TEST(difference(exact.velocity, cvode.velocity) <=
                   100 * impact::estimate_accuracy(chain, {.accuracy = 1e-9, .flow = flow::Kind::cvode_adams},
                                                   cvode));
      for (std::size_t j = 0; j < exact.contacts.size(); ++j)
        BOOST_TEST(std::abs(exact.contacts[j].peak_force - cvode.contacts[j].peak_force) <=
                   1e-5 * (1e-3 + cvode.contacts[j].peak_force));
    }
  }
}

namespace {

struct CountPieces final : flow::StepObserver {
  void observe(const flow::Step& step) override {
    tiles = tiles && step.start == end;
    end = step.end;
    ++pieces;
  }
  Index pieces = 0;
  double end = 0;
  bool tiles = true;
};

struct Followed {
  flow::Arrival arrival;
  long allocations;
  std::vector<double> x;
};

/// The first phase of a chain, followed by a flow that may have memory already.
Followed follow_first(flow::Flow& flow, const model::Chain& chain, flow::StepObserver* observer = nullptr) {
  model::ChainSystem system;
  system.reset(chain, 1e-10, false);
  std::vector<model::ContactChange> changes;
  std::vector<double> x;
  initial_state(system.chain(), system.layout(), x);
  model::ChainSystem::Mode mode;
  system.mode_at(x, mode, changes);
  auto& problem = system.problem(mode);
  std::vector<Index> fired;
  fired.reserve(8);
  const long before = allocations;
  BOOST_REQUIRE(flow.admits(problem));
  auto arrival = flow.follow(problem, x, {.observer = observer}, fired);
  return {arrival, allocations - before, x};
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_allocated_in_the_second_phase_of_a_size) {
  for (const auto& laws :
       {std::vector<contact::Law>{contact::Linear{1}, contact::Linear{7}, contact::Linear{2}},
        std::vector{damper(1, 0.1), damper(7, 0.7), damper(2, 0.2)},
        std::vector{damper(1, 0.1), damper(7, 3), contact::Law(contact::Linear{2})}}) {
    const auto chain = equal_masses(laws, {1, 0, 0, 0});
    const auto modal = flow::make_modal_flow();
    CountPieces observer;
    const auto first = follow_first(*modal, chain, &observer),
               second = follow_first(*modal, chain, &observer);
    BOOST_TEST(first.allocations > 0);
    BOOST_TEST(second.allocations == 0);
    BOOST_TEST(second.x == first.x, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_watcher_sees_few_pieces_that_tile_the_phase) {
  for (const double ratio : {1e-4, 1.0, 1e4, 1e7, 1e10}) {
    const auto chain = equal_masses({contact::Linear{1}, contact::Linear{ratio}}, {1, 0, 0});
    const auto modal = flow::make_modal_flow();
    CountPieces observer;
    const auto followed = follow_first(*modal, chain, &observer);
    BOOST_TEST(observer.pieces <= 5);
    BOOST_TEST(observer.tiles);
    BOOST_TEST(observer.end == followed.arrival.duration);
  }
}

BOOST_AUTO_TEST_CASE(peaks_of_stiff_contacts_are_the_largest_of_all) {
  // Beside a stiff contact the soft one sees two balls as one, and the stiff one carries half the force; its
  // own vibration, started with nothing, doubles none of it.
  for (const double ratio : {1e6, 1e8, 1e10}) {
    const auto impact =
        impact::simulate(equal_masses({contact::Linear{1}, contact::Linear{ratio}}, {1, 0, 0}));
    const double force = std::sqrt(2.0 / 3);
    BOOST_TEST(std::abs(impact.contacts[0].peak_force - force) < 2 / std::sqrt(ratio));
    BOOST_TEST(std::abs(impact.contacts[1].peak_force - force / 2) < 2 / std::sqrt(ratio));
  }
}
