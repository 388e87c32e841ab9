#define BOOST_TEST_MODULE rival laws
#include <boost/test/unit_test.hpp>
#include <functional>
#include <map>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain_solver.hpp"
#include "mariotte/impact/complementarity.hpp"
#include "mariotte/impact/liu_zhao_brogliato_law.hpp"
#include "mariotte/impact/moreau_law.hpp"
#include "mariotte/impact/newton_law.hpp"
#include "mariotte/impact/poisson_law.hpp"
#include "mariotte/impact/sequential_law.hpp"
#include "support/random_configurations.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::impact;
using test::difference;
using test::Numbers;

namespace {

const auto to_rounding = boost::test_tools::tolerance(1e-12);
constexpr double third = 1.0 / 3;

Configuration struck_row(std::size_t balls) {
  Numbers velocity(balls, 0.0);
  velocity[0] = 1;
  return chain_configuration(Numbers(balls, 1.0), velocity);
}

/// Balls of random masses that touch and all approach, or in any motion.
enum class Motion { approach, any };
Configuration random_row(std::mt19937_64& random, Motion motion) {
  std::uniform_real_distribution<double> unit(0, 1);
  const int balls = std::uniform_int_distribution(2, 8)(random);
  Numbers mass, velocity;
  for (int i = 0; i < balls; ++i) {
    mass.push_back(std::pow(10, 2 * unit(random) - 1));
    velocity.push_back(2 * unit(random) - 1);
  }
  if (motion == Motion::approach) std::sort(velocity.rbegin(), velocity.rend());
  return chain_configuration(mass, velocity);
}

struct NamedLaw {
  const char* name;
  std::function<LawOutcome(const Configuration&, double e)> apply;
};

Numbers all(const Configuration& c, double value) {
  return Numbers(c.contact.size(), value);
}

LawOutcome distributed(const Configuration& c, double e, double exponent = 1.5, double accuracy = 1e-10) {
  return liu_zhao_brogliato(
      c, {.restitution = all(c, e), .stiffness = all(c, 1), .exponent = exponent, .accuracy = accuracy});
}

const std::vector<NamedLaw> laws = {
    {"newton", [](const Configuration& c, double e) { return newton(c, all(c, e)); }},
    {"poisson", [](const Configuration& c, double e) { return poisson(c, all(c, e)); }},
    {"moreau", [](const Configuration& c, double e) { return moreau(c, e); }},
    {"left to right",
     [](const Configuration& c, double e) { return left_to_right(c, {.restitution = all(c, e)}); }},
    {"by event", [](const Configuration& c, double e) { return by_event(c, {.restitution = all(c, e)}); }},
    {"liu-zhao-brogliato", [](const Configuration& c, double e) { return distributed(c, e); }},
};

double momentum(const Configuration& c, const Numbers& velocity) {
  double sum = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i) sum += c.mass[i] * velocity[i];
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(complementarity_problems_are_solved_with_redundant_contacts_too) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 500; ++i) {
    const auto c = test::random_configuration(random);  // half of them with more contacts than freedoms
    const auto w = compliance(c), q = gap_rates(c, c.velocity);
    const auto p = solve_complementarity(w, q);
    const std::size_t m = q.size();
    double scale = 0;
    for (const double rate : q) scale = std::max(scale, std::abs(rate));
    for (std::size_t j = 0; j < m; ++j) {
      double rate = q[j];
      for (std::size_t k = 0; k < m; ++k) rate += w[j * m + k] * p[k];
      BOOST_TEST(p[j] >= 0);
      BOOST_TEST(rate >= -1e-10 * scale);
      if (p[j] > 0) BOOST_TEST(std::abs(rate) < 1e-10 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_law_keeps_momentum_pushes_only_and_lets_no_gap_close) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 25; ++i) {
    const auto c = random_row(random, Motion::approach);
    for (const double e : {0.3, 0.8, 1.0})
      for (const auto& law : laws) {
        BOOST_TEST_CONTEXT(law.name << ", e = " << e << ", row " << i) {
          const auto outcome = law.apply(c, e);
          BOOST_TEST((outcome.status == LawStatus::admissible), reason(outcome));
          BOOST_TEST(std::abs(momentum(c, outcome.velocity) - momentum(c, c.velocity)) < 1e-11);
        }
      }
  }
}

BOOST_AUTO_TEST_CASE(newton_and_moreau_alone_may_close_a_gap_that_parted_before) {
  std::mt19937_64 random(15);
  std::map<std::string, int> closing;
  for (int i = 0; i < 25; ++i) {
    const auto c = random_row(random, Motion::any);
    for (const auto& law : laws) {
      const auto outcome = law.apply(c, 0.7);
      if (outcome.status == LawStatus::admissible) continue;
      BOOST_TEST((outcome.status == LawStatus::penetrating_velocity));
      BOOST_TEST(gap_rates(c, c.velocity)[*outcome.contact] > 0);
      ++closing[law.name];
    }
  }
  BOOST_TEST(closing.size() == 2);
  BOOST_TEST(closing["newton"] > 5);
  BOOST_TEST(closing["moreau"] > 5);
}

BOOST_AUTO_TEST_CASE(no_law_gains_energy_and_elastic_ones_keep_it) {
  std::mt19937_64 random(12);
  for (int i = 0; i < 25; ++i) {
    const auto c = random_row(random, Motion::any);
    for (const auto& law : laws) {
      BOOST_TEST_CONTEXT(law.name << ", row " << i) {
        BOOST_TEST(*law.apply(c, 0.6).ratio_lab <= 1 + 1e-12);
        BOOST_TEST(*law.apply(c, 1).ratio_lab <= 1 + 1e-8);
        if (law.name != std::string("poisson"))
          BOOST_TEST(*law.apply(c, 1).ratio_lab == 1, boost::test_tools::tolerance(1e-8));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(newton_with_different_restitutions_can_gain_energy) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> unit(0, 1);
  double most = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto c = random_row(random, Motion::any);
    Numbers e;
    for (std::size_t j = 0; j < c.contact.size(); ++j) e.push_back(unit(random));
    most = std::max(most, *newton(c, e).ratio_centre);
  }
  BOOST_TEST(most > 1.01);
}

BOOST_AUTO_TEST_CASE(newton_and_moreau_agree_where_all_restitutions_are_equal) {
  std::mt19937_64 random(14);
  for (int i = 0; i < 200; ++i) {
    const auto c = test::random_configuration(random);
    for (const double e : {0.0, 0.5, 1.0})
      BOOST_TEST(difference(newton(c, all(c, e)).velocity, moreau(c, e).velocity) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(simultaneous_laws_leave_two_balls_together_and_sequences_one_alone) {
  const auto row = struck_row(3);
  for (const auto* name : {"newton", "poisson", "moreau"})
    for (const auto& law : laws)
      if (law.name == std::string(name))
        BOOST_TEST(difference(law.apply(row, 1).velocity, {-third, 2 * third, 2 * third}) < 1e-15);
  for (const auto& law : {laws[3], laws[4]})
    BOOST_TEST(difference(law.apply(row, 1).velocity, {0, 0, 1}) < 1e-15);
}

BOOST_AUTO_TEST_CASE(order_of_collisions_decides_what_comes_out) {
  const auto c = chain_configuration({1, 3, 1}, {1, 0, -1.5});
  const SequentialOptions elastic{.restitution = {1, 1}};
  const auto first = by_event(c, elastic, {1e-3, 1}), last = by_event(c, elastic, {1, 1e-3});
  BOOST_TEST(difference(first.velocity, left_to_right(c, elastic).velocity) < 1e-12);
  BOOST_TEST(difference(first.velocity, last.velocity) > 0.1);
}

// Three equal balls collide for ever if e < 7 − 4√3 [McNamara & Young 1992].
BOOST_AUTO_TEST_CASE(inelastic_collapse_ends_with_balls_at_rest_to_each_other) {
  const auto c = chain_configuration({1, 1, 1}, {1, 0, -1});
  const double collapse = 7 - 4 * std::sqrt(3.0);
  const auto above = by_event(c, {.restitution = all(c, collapse + 0.02)}, {1, 1.3});
  const auto below = by_event(c, {.restitution = all(c, collapse - 0.02)}, {1, 1.3});
  BOOST_TEST((below.status == LawStatus::admissible));
  BOOST_TEST(below.steps > 2 * above.steps);
  BOOST_TEST(std::abs(below.velocity[2] - below.velocity[0]) < 1e-10);
  const auto cut = by_event(c, {.restitution = all(c, 0.01), .most_collisions = 3}, {1, 1.3});
  BOOST_TEST((cut.status == LawStatus::unfinished));
}

BOOST_AUTO_TEST_CASE(elastic_distribution_law_is_the_compliant_chain) {
  for (const auto& c : test::cases("equal_chains.json")) {
    if (c.at("n") > 10) continue;
    BOOST_TEST(difference(distributed(struck_row(c.at("n")), 1).velocity, c.at("final")) < 1e-8);
  }
  for (const auto& c : test::cases("linear_triplets.json")) {
    if (c.at("kappa") > 20) continue;
    const auto outcome = liu_zhao_brogliato(
        struck_row(3), {.restitution = {1, 1}, .stiffness = {1, c.at("kappa")}, .exponent = 1});
    BOOST_TEST(difference(outcome.velocity, c.at("final")) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(distribution_law_loses_what_each_contact_does_not_give_back) {
  const auto pair = chain_configuration({1, 2}, {1, 0});
  for (const double e : {0.1, 0.5, 0.9}) {
    const auto outcome = distributed(pair, e);
    BOOST_TEST(outcome.velocity[1] - outcome.velocity[0] == e, boost::test_tools::tolerance(1e-8));
    BOOST_TEST(*outcome.ratio_centre == e * e, boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(distribution_law_is_of_high_order) {
  const auto exact = test::cases("equal_chains.json")[2].at("final").get<Numbers>();
  const auto row = struck_row(exact.size());
  const auto coarse = distributed(row, 1, 1.5, 1e-5), fine = distributed(row, 1, 1.5, 1e-11);
  const double gain = std::log(difference(coarse.velocity, exact) / difference(fine.velocity, exact));
  const double work = std::log(static_cast<double>(fine.steps) / static_cast<double>(coarse.steps));
  BOOST_TEST(gain / work > 3.5);  // 5, less what the onsets take, where the force has no fifth derivative
}

BOOST_AUTO_TEST_CASE(parameters_without_sense_are_refused) {
  const auto c = struck_row(3);
  for (const double e : {-0.1, 1.1, std::nan("")})
    for (const auto& law : laws) BOOST_CHECK_THROW(law.apply(c, e), InvalidParameter);
  BOOST_CHECK_THROW(distributed(c, 0), InvalidParameter);
  BOOST_CHECK_THROW(newton(c, {1}), InvalidParameter);
  BOOST_CHECK_THROW(by_event(c, {.restitution = {1, 1}}, {1, 0}), InvalidParameter);
  BOOST_CHECK_THROW(newton(chain_configuration({infinity, infinity}, {1, 0}), {1}), InvalidParameter);
}
