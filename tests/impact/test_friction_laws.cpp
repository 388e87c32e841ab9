// Impact laws with friction: closed forms, what they promise of energy, and the path they follow.
#define BOOST_TEST_MODULE friction laws
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/laws/friction_laws.hpp"

using namespace mariotte;
using namespace mariotte::impact;

namespace {

using Law = InContact (*)(const FrictionalContact&, double);
struct NamedLaw {
  const char* name;
  Law apply;
};
constexpr NamedLaw laws[] = {
    {"newton", newton}, {"poisson", poisson}, {"moreau", moreau}, {"stronge", stronge}};

/// A solid ball of mass 1 that strikes a plane at an angle from the normal: W_tt = 7/2.
FrictionalContact ball(double angle, double friction) {
  return {1, 0, 3.5, {-std::cos(angle), std::sin(angle)}, friction};
}

/// A thin rod of mass 1 and length 2 on its lower end: lever (−cos θ, −sin θ), J = 1/3.
FrictionalContact rod(double angle, double friction, const InContact& velocity) {
  const double x = -std::cos(angle), y = -std::sin(angle);
  return {1 + 3 * x * x, -3 * x * y, 1 + 3 * y * y, velocity, friction};
}

/// Any two bodies, any velocity that closes the gap.
FrictionalContact random_contact(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  FrictionalContact c{.nn = 0.3 + 2 * unit(random), .tt = 0.3 + 2 * unit(random)};
  c.nt = (1.8 * unit(random) - 0.9) * std::sqrt(c.nn * c.tt);
  c.velocity = {-unit(random) - 1e-3, 4 * unit(random) - 2};
  c.friction = 2 * unit(random);
  return c;
}

/// Coulomb's law at every one of many small impulses: until the gap rate is zero and `more`, of the impulses
/// and the works of the normal force until then and from then on, is false.
template <class More>
InContact in_small_steps(const FrictionalContact& c, double step, More&& more) {
  InContact p, half;
  double work = 0, half_work = 0;
  bool expands = false;
  for (;;) {
    const auto u = velocity_after(c, p);
    if (!expands && u.normal >= 0) expands = true, half = p, half_work = work;
    if (expands && !more(half.normal, p.normal - half.normal, half_work, work - half_work)) return p;
    const double needed = -(u.tangential + c.nt * step) / c.tt;  // to stick at the end of the step
    p.normal += step;
    p.tangential += std::clamp(needed, -c.friction * step, c.friction * step);
    work += 0.5 * step * (u.normal + velocity_after(c, p).normal);
  }
}

void check_near(const InContact& p, const InContact& expected, double tolerance) {
  BOOST_TEST(std::abs(p.normal - expected.normal) <= tolerance, p.normal << " not " << expected.normal);
  BOOST_TEST(std::abs(p.tangential - expected.tangential) <= tolerance,
             p.tangential << " not " << expected.tangential);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_ball_that_sticks_keeps_five_sevenths_but_by_moreau) {
  const auto c = ball(0.3, 0.4);
  for (const double e : {0.0, 0.6, 1.0})
    for (const auto& law : laws) {
      const auto p = law.apply(c, e);
      const double kept = (c.velocity.tangential + p.tangential) / c.velocity.tangential;
      const double back = law.apply == moreau ? e : 0;
      BOOST_TEST(std::abs(kept - (1 - 2 * (1 + back) / 7)) < 1e-14, law.name << ", e = " << e);
      BOOST_TEST(std::abs(velocity_after(c, p).normal + e * c.velocity.normal) < 1e-14);
    }
}

BOOST_AUTO_TEST_CASE(all_laws_agree_where_a_ball_slips_to_the_end) {
  const auto c = ball(1.3, 0.1);
  for (const double e : {0.0, 0.6, 1.0})
    for (const auto& law : laws) {
      const double p = (1 + e) * std::cos(1.3);
      check_near(law.apply(c, e), {p, -0.1 * p}, 1e-14);
    }
}

// A rod at 45° with W_nn = W_tt = 5/2, W_nt = −3/2 whose friction cannot hold it: slip turns round. By
// Newton's law all of the impulse p_n = 2/(W_nn + μ W_nt) has the friction of the reversed slip, which drives
// the slip there was before: ΔT = ½ p_t (u⁻ + u⁺) > 0.
BOOST_AUTO_TEST_CASE(newtons_law_lets_a_rod_gain_energy_where_slip_turns_round) {
  const double slip = 0.9, mu = 0.1;
  const auto c = rod(std::numbers::pi / 4, mu, {-1, slip});
  const double normal = 2 / (2.5 - 1.5 * mu), after = slip - normal * (1.5 - 2.5 * mu);
  BOOST_TEST(after < 0);
  check_near(newton(c, 1), {normal, mu * normal}, 1e-14);
  BOOST_TEST(energy_change(c, newton(c, 1)) == 0.5 * mu * normal * (slip + after),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(slip + after > 0);
  for (const auto law : {poisson, moreau, stronge}) BOOST_TEST(energy_change(c, law(c, 1)) < -1e-3);
}

BOOST_AUTO_TEST_CASE(only_newtons_law_gains_energy) {
  std::mt19937_64 random(5);
  int gains = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto c = random_contact(random);
    for (const double e : {0.0, 0.5, 1.0}) {
      for (const auto law : {poisson, moreau, stronge}) BOOST_TEST(energy_change(c, law(c, e)) < 1e-12);
      gains += energy_change(c, newton(c, e)) > 1e-12;
    }
  }
  BOOST_TEST(gains > 1000);
}

BOOST_AUTO_TEST_CASE(impulses_are_in_the_cone_and_gaps_open) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 20000; ++i) {
    const auto c = random_contact(random);
    for (const auto& law : laws) {
      const auto p = law.apply(c, 0.7);
      BOOST_TEST(std::abs(p.tangential) <= c.friction * p.normal * (1 + 1e-12), law.name);
      BOOST_TEST(velocity_after(c, p).normal > 0, law.name);
    }
    const auto p = newton(c, 0.7);
    const double slip = velocity_after(c, p).tangential, least = 1e-9 * (1 + c.friction * p.normal);
    BOOST_TEST(std::abs(velocity_after(c, p).normal + 0.7 * c.velocity.normal) < 1e-9);
    BOOST_TEST((std::abs(slip) < least ||
                std::abs(p.tangential + std::copysign(c.friction, slip) * p.normal) < least));
  }
}

BOOST_AUTO_TEST_CASE(poissons_and_stronges_laws_follow_coulomb_at_every_instant) {
  std::mt19937_64 random(7);
  const double e = 0.8;
  for (int i = 0; i < 30; ++i) {
    const auto c = random_contact(random);
    const double step = 1e-4 * poisson(c, e).normal;
    const auto by_impulse = [&](double half, double rest, double, double) { return rest < e * half; };
    const auto by_work = [&](double, double, double half, double rest) { return rest < -e * e * half; };
    check_near(poisson(c, e), in_small_steps(c, step, by_impulse), 10 * step);
    check_near(stronge(c, e), in_small_steps(c, step, by_work), 10 * step);
  }
}

// Painlevé: while the rod slides its end is drawn in. It turns back once the slip has ended.
BOOST_AUTO_TEST_CASE(a_rod_that_jams_turns_back_once_its_slip_has_ended) {
  const double angle = std::numbers::pi / 3, mu = 1.8;
  const auto c = rod(angle, mu, {-0.02, -1});
  BOOST_TEST(c.nn + mu * c.nt < 0);
  const double until = 1 / (c.nt + mu * c.tt), drawn = -0.02 + until * (c.nn + mu * c.nt);
  const double half = until - drawn / (c.nn - c.nt * c.nt / c.tt);
  BOOST_TEST(poisson(c, 1).normal == 2 * half, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(velocity_after(c, stronge(c, 1)).normal > 10 * 0.02);
  BOOST_TEST(std::abs(velocity_after(c, newton(c, 1)).normal - 0.02) < 1e-13);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const auto c = ball(0.3, 0.4);
  const auto refused = [](const FrictionalContact& wrong, double e) {
    for (const auto& law : laws) BOOST_CHECK_THROW(law.apply(wrong, e), InvalidParameter);
  };
  refused(c, -0.1);
  refused({1, 2, 3, c.velocity, 0.1}, 1);
  refused({1, 0, 3, {0, 1}, 0.1}, 1);
  refused({1, 0, 3, c.velocity, -0.1}, 1);
}
