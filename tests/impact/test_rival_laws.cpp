#define BOOST_TEST_MODULE rival laws
#include <boost/test/unit_test.hpp>
#include <functional>
#include <map>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/laws/ceanga_hurmuzlu_law.hpp"
#include "mariotte/impact/laws/complementarity.hpp"
#include "mariotte/impact/laws/liu_zhao_brogliato_law.hpp"
#include "mariotte/impact/laws/moreau_law.hpp"
#include "mariotte/impact/laws/multiple_impact_law.hpp"
#include "mariotte/impact/laws/newton_law.hpp"
#include "mariotte/impact/laws/poisson_law.hpp"
#include "mariotte/impact/laws/sequential_law.hpp"
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
      c,
      {.restitution = all(c, e), .stiffness = all(c, 1), .exponent = all(c, exponent), .accuracy = accuracy});
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
    const auto c = test::random_configuration(random);  // half of them with more contacts than dofs
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
        struck_row(3), {.restitution = {1, 1}, .stiffness = {1, c.at("kappa")}, .exponent = {1, 1}});
    BOOST_TEST(difference(outcome.velocity, c.at("final")) < 1e-8);
  }
  const model::Chain mixed{.mass = {1, 1, 1},
                           .law = {contact::Hertz{1}, contact::Linear{100}},
                           .gap = {0, 0},
                           .velocity = {1, 0, 0}};
  const auto outcome =
      liu_zhao_brogliato(struck_row(3), {.restitution = {1, 1}, .stiffness = {1, 100}, .exponent = {1.5, 1}});
  BOOST_TEST(difference(outcome.velocity, impact::simulate(mixed).velocity) < 1e-8);
}

// It is not where a gap opens between two periods of a contact: the law loads such a contact again at once.
BOOST_AUTO_TEST_CASE(elastic_distribution_law_is_the_chain_only_if_no_contact_closes_twice) {
  std::mt19937_64 random(16);
  int once = 0, off = 0;
  for (int i = 0; i < 60; ++i) {
    const auto c = random_row(random, Motion::approach);
    const model::Chain chain{.mass = c.mass,
                             .law = std::vector<contact::Law>(c.contact.size(), contact::Hertz{1}),
                             .gap = all(c, 0),
                             .velocity = c.velocity};
    const auto impact = impact::simulate(chain);
    const bool again = std::any_of(impact.contacts.begin(), impact.contacts.end(),
                                   [](const auto& contact) { return contact.periods.size() > 1; });
    const double error = difference(distributed(c, 1).velocity, impact.velocity);
    if (!again) BOOST_TEST(error < 1e-7);
    once += !again;
    off += error > 0.01;
  }
  BOOST_TEST(once > 10);
  BOOST_TEST(off > 5);
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

namespace {

LawOutcome correlated(const Configuration& c, const Numbers& e, const Numbers& direction) {
  return ceanga_hurmuzlu(c, {.restitution = e, .direction = direction});
}

Numbers random_numbers(std::mt19937_64& random, std::size_t count, double least) {
  std::uniform_real_distribution<double> value(least, 1);
  Numbers list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(value(random));
  return list;
}

/// Energy that the law says is lost, Σ (1 − e_j²) times what contact j takes up, by the trapezoidal rule
/// along the impulses, on which gap rates are linear.
double loss_along(const Configuration& c, const Numbers& e, const Numbers& p) {
  constexpr int parts = 20000;
  const auto before = gap_rates(c, c.velocity), change = gap_rates(c, velocity_change(c, p));
  double loss = 0;
  for (std::size_t j = 0; j < p.size(); ++j)
    for (int k = 0; k < parts; ++k) {
      const auto taken = [&](int at) { return std::max(0.0, -p[j] * (before[j] + change[j] * at / parts)); };
      loss += (1 - e[j] * e[j]) * 0.5 * (taken(k) + taken(k + 1)) / parts;
    }
  return loss;
}

}  // namespace

BOOST_AUTO_TEST_CASE(correlation_law_of_two_bodies_is_restitution) {
  for (const double e : {0.0, 0.3, 1.0}) {
    const auto outcome = correlated(chain_configuration({1, 2}, {1, -0.5}), {e}, {1});
    BOOST_TEST(outcome.velocity[1] - outcome.velocity[0] == 1.5 * e, to_rounding);
    BOOST_TEST((outcome.status == LawStatus::admissible));
  }
}

// Equal balls, v = (1, 0, 0), p = (α s, s): w = (−1 + (2α−1) s, (2−α) s), and for 1 < α < 2 contact 1 turns
// at 1/(2α−1) and contact 2 opens throughout, so the end is the larger root of a quadratic.
BOOST_AUTO_TEST_CASE(correlation_law_of_the_triplet_is_the_root_of_a_quadratic) {
  for (const double icr : {1.05, 1.4, 1.9})
    for (const double e : {0.95, 0.98, 1.0}) {
      const double bend = 2 * icr - 1, other = 2 - icr, turn = 1 / bend;
      // e² α turn/2 = α bend (s − turn)²/2 + other s²/2
      const double a = icr * bend + other, b = -2 * icr, k = icr * turn * (1 - e * e);
      const double s = (-b + std::sqrt(b * b - 4 * a * k)) / (2 * a);
      const auto outcome = correlated(struck_row(3), {e, 0.1}, {icr, 1});
      BOOST_TEST(difference(outcome.velocity, {1 - icr * s, (icr - 1) * s, s}) < 1e-13);
    }
}

BOOST_AUTO_TEST_CASE(elastic_correlation_law_is_the_multiple_impact_law_and_so_the_chain) {
  std::mt19937_64 random(21);
  for (int i = 0; i < 200; ++i) {
    const auto c = random_row(random, Motion::approach);
    const auto r = random_numbers(random, c.contact.size(), 0);
    const auto law = multiple_impact(c, {.direction = r, .energy_ratio = 1});
    BOOST_TEST(difference(correlated(c, all(c, 1), r).velocity, law.velocity) < 1e-11);
  }
  for (const auto& c : test::cases("equal_chains.json")) {
    const auto row = struck_row(c.at("n"));
    const auto final = c.at("final").get<Numbers>();
    Numbers p = {1 - final[0]};
    for (std::size_t i = 1; i + 1 < final.size(); ++i) p.push_back(p.back() - final[i]);
    BOOST_TEST(difference(correlated(row, all(row, 1), p).velocity, final) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(correlation_law_loses_what_each_contact_does_not_give_back) {
  std::mt19937_64 random(22);
  for (int i = 0; i < 100; ++i) {
    const auto c = random_row(random, i % 2 ? Motion::approach : Motion::any);
    const auto e = random_numbers(random, c.contact.size(), 0), r = random_numbers(random, e.size(), 0);
    const auto outcome = correlated(c, e, r);
    const double before = kinetic_energy(c, c.velocity), after = kinetic_energy(c, outcome.velocity);
    BOOST_TEST(std::abs(before - after - loss_along(c, e, outcome.impulse)) < 1e-7 * before);
    BOOST_TEST(std::abs(momentum(c, outcome.velocity) - momentum(c, c.velocity)) < 1e-11);
    for (std::size_t j = 1; j < r.size(); ++j)
      BOOST_TEST(std::abs(outcome.impulse[j] * r[0] - outcome.impulse[0] * r[j]) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(correlation_law_says_what_is_not_admissible) {
  const auto row = struck_row(3);
  BOOST_TEST((correlated(row, {0.2, 0.2}, {1.2, 1}).status == LawStatus::penetrating_velocity));
  BOOST_TEST((correlated(row, {1, 1}, {1, -1}).status == LawStatus::tensile_impulse));
  for (const Numbers& r : {Numbers{0, 1}, Numbers{0, 0}}) {
    const auto outcome = correlated(row, {1, 1}, r);
    BOOST_TEST((outcome.status == LawStatus::no_impact));
    BOOST_TEST(outcome.velocity == row.velocity, boost::test_tools::per_element());
  }
  BOOST_CHECK_THROW(correlated(row, {1, 1.1}, {1, 1}), InvalidParameter);
  BOOST_CHECK_THROW(correlated(row, {1, 1}, {1}), InvalidParameter);
  BOOST_CHECK_THROW(correlated(row, {1, 1}, {1, infinity}), InvalidParameter);
}

BOOST_AUTO_TEST_CASE(every_law_is_homogeneous_in_speed_and_mass_or_refuses) {
  const auto at = [](double mass, double speed) {
    return chain_configuration({mass, 0.5 * mass, mass}, {speed, 0, -0.25 * speed});
  };
  for (const auto& law : laws) {
    const auto expected = law.apply(at(1, 1), 0.8).velocity;
    int found = 0;
    for (int mass = -300; mass <= 300; mass += 60)
      for (int speed = -300; speed <= 300; speed += 60) try {
          auto velocity = law.apply(at(std::pow(10, mass), std::pow(10, speed)), 0.8).velocity;
          for (double& v : velocity) v /= std::pow(10, speed);
          BOOST_TEST(difference(velocity, expected) < 1e-8);
          ++found;
        } catch (const InvalidParameter& refusal) {
          BOOST_TEST(std::string(refusal.what()).find("double precision") != std::string::npos);
        }
    BOOST_TEST(found > 20);
  }
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
