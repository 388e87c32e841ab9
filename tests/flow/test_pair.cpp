#define BOOST_TEST_MODULE pair flow
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/flow/pair/pair_motion.hpp"
#include "support/random_chains.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;
using flow::Indentation;
using flow::PairLaw;

namespace {

constexpr PairLaw hertz{.stiffness = 3, .damping = 0, .exponent = 1.5, .reduced_mass = 0.7};
constexpr PairLaw linear{.stiffness = 3, .damping = 0, .exponent = 1, .reduced_mass = 0.7};

PairLaw damped(double damping) {
  return {.stiffness = 1, .damping = damping, .exponent = 1, .reduced_mass = 0.5};
}

template <class Visit>
auto ask(const flow::PairMotion& motion, Visit&& visit) {
  return std::visit(visit, motion);
}
double duration(const flow::PairMotion& motion) {
  return ask(motion, [](const auto& one) { return one.opening().time; });
}
Indentation at(const flow::PairMotion& motion, double time) {
  return ask(motion, [&](const auto& one) { return one.at(time); });
}

std::vector<PairLaw> all_laws() {
  std::vector<PairLaw> laws = {hertz, linear};
  // Through critical damping, which is at √2 here, and far beyond it.
  for (const double c : {1e-3, 0.1, 1.0, 1.4142, std::sqrt(2.0), 1.4143, 1.5, 2.0, 10.0, 1e4, 1e7})
    laws.push_back(damped(c));
  return laws;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_hertz_contact_lasts_as_long_as_it_should) {
  // Reference: two unit balls, k = 1, v = 1, from the first contact of the triplets with v₃ = 1/2.
  const auto motion = flow::make_pair_motion({1, 0, 1.5, 0.5}, {0, 1});
  BOOST_TEST(duration(motion) == 2.438837564705526874, boost::test_tools::tolerance(5e-16));
}

BOOST_AUTO_TEST_CASE(any_instant_may_be_a_new_start) {
  for (const auto& law : all_laws()) {
    const auto whole = flow::make_pair_motion(law, {0, 1.3});
    const double total = duration(whole);
    for (const double part : {1e-6, 0.01, 0.2, 0.4, 0.5, 0.6, 0.9, 0.999}) {
      const double time = part * total;
      const auto rest = flow::make_pair_motion(law, at(whole, time));
      BOOST_TEST_CONTEXT("damping " << law.damping << " part " << part) {
        // Far beyond critical damping a state late in the contact determines the rest of it badly.
        if (law.damping <= 10) BOOST_TEST(std::abs(time + duration(rest) - total) < 1e-11 * total);
        BOOST_TEST(std::abs(at(rest, duration(rest)).rate - at(whole, total).rate) < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_force_is_zero_at_the_end_and_not_before) {
  for (const auto& law : all_laws()) {
    const auto motion = flow::make_pair_motion(law, {0, 1});
    const auto force = [&](double time) {
      const auto [depth, rate] = at(motion, time);
      return law.stiffness * std::pow(std::max(0.0, depth), law.exponent) + law.damping * rate;
    };
    const double total = duration(motion),
                 size = std::max({force(0.0), force(0.5 * total), force(0.1 * total)});
    BOOST_TEST(std::abs(force(total)) < 1e-9 * size);
    for (int i = 1; i < 100; ++i) BOOST_TEST(force(0.01 * i * total) > 0);
  }
}

BOOST_AUTO_TEST_CASE(the_rate_is_the_derivative_of_the_indentation) {
  for (const auto& law : all_laws()) {
    const auto motion = flow::make_pair_motion(law, {0, 1});
    const double total = duration(motion), h = 1e-5 * total;
    for (const double part : {0.1, 0.3, 0.5, 0.8, 0.95}) {
      const double slope =
          (at(motion, part * total + h).value - at(motion, part * total - h).value) / (2 * h);
      BOOST_TEST(std::abs(slope - at(motion, part * total).rate) < 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(another_gap_closes_exactly_where_its_concave_course_ends) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const auto& law : all_laws()) {
    const auto motion = flow::make_pair_motion(law, {0, 1});
    const double total = duration(motion), last = at(motion, total).value;
    for (int i = 0; i < 200; ++i) {
      const flow::ConcaveGap gap{i % 3 ? 0.3 * uniform(random) * total : 0, 2 * uniform(random) - 1.5,
                                 i % 5 ? uniform(random) : 0};
      const auto value = [&](double time) {
        return gap.value + gap.rate * time + gap.coupling * at(motion, time).value;
      };
      if (gap.value + gap.rate * total + gap.coupling * last > 0 ||
          (gap.value == 0 && gap.rate + gap.coupling <= 0))
        continue;
      const double time = ask(motion, [&](const auto& one) { return one.fall(gap); });
      BOOST_TEST(std::abs(value(time)) < 1e-13 * total);
      for (const double part : {0.1, 0.5, 0.9, 0.99}) BOOST_TEST(value(part * time) > 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_pair_of_any_law_is_exact) {
  for (const auto& law : {contact::Law(contact::Linear{2}), contact::Law(contact::Hertz{2})}) {
    const auto impact = impact::simulate({.mass = {1, 3}, .law = {law}, .gap = {0.1}, .velocity = {1, 0}});
    BOOST_TEST(difference(impact.velocity, {-0.5, 0.5}) < 4e-16);
    BOOST_TEST(impact.flows.back().name == "pair");
  }
}

BOOST_AUTO_TEST_CASE(pairs_in_random_chains_are_followed_as_cvode_follows_them) {
  std::mt19937_64 random(1671);
  for (int i = 0; i < 200; ++i) {
    const auto chain = random_chain(random);
    const auto by_pair = impact::simulate(chain, {.accuracy = 1e-9});
    const auto by_cvode = impact::simulate(chain, {.accuracy = 1e-9, .flow = flow::Kind::cvode_adams});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST(period_counts(by_pair) == period_counts(by_cvode), boost::test_tools::per_element());
      if (difference(by_pair.velocity, by_cvode.velocity) > 2e-9)
        BOOST_TEST(difference(by_pair.velocity, by_cvode.velocity) <=
                   100 * impact::estimate_accuracy(chain, {.accuracy = 1e-9, .flow = flow::Kind::cvode_adams},
                                                   by_cvode));
      for (std::size_t j = 0; j < by_pair.contacts.size(); ++j) {
        const auto &a = by_pair.contacts[j], &b = by_cvode.contacts[j];
        BOOST_TEST(std::abs(a.peak_force - b.peak_force) <= 1e-5 * (1e-3 + b.peak_force));
        BOOST_TEST(std::abs(a.dissipated - b.dissipated) <= 1e-5 * (1e-3 + b.dissipated));
      }
    }
  }
}

// 1e-9 − t + δ/2 with δ = t but for t^{7/2}: right after the touch, where y = −1 tells little of δ.
BOOST_AUTO_TEST_CASE(a_gap_that_closes_right_after_the_touch_closes_on_time) {
  const auto motion = flow::make_pair_motion(
      {.stiffness = 1, .damping = 0, .exponent = 1.5, .reduced_mass = 1}, {.value = 0, .rate = 1});
  for (const double width : {1e-6, 1e-9, 1e-12})
    BOOST_TEST(std::abs(std::visit(
                            [&](const auto& one) {
                              return one.fall({width, -1, 0.5});
                            },
                            motion) -
                        2 * width) < 4 * epsilon);
}
