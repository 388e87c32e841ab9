// Restitution of pairs by simulation, in closed form, and from references; capture velocities.
#define BOOST_TEST_MODULE pair restitution
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/impact/pair/pair_restitution.hpp"
#include "support/reference_laws.hpp"

using namespace mariotte;
using impact::Pair;

namespace {

Pair pair_of(const nlohmann::json& c) {
  const auto chain = test::chain_of(c);
  return {chain.law[0], 1 / (1 / chain.mass[0] + 1 / chain.mass[1])};
}

}  // namespace

// A restitution loses digits where the pair is almost captured, as 1/e².
BOOST_AUTO_TEST_CASE(closed_forms_are_the_references_and_the_simulation) {
  int closed_forms = 0;
  for (const auto& c : test::law_cases("pairs.json")) {
    const auto pair = pair_of(c);
    const auto velocity = test::sizes(c.at("velocity"));
    const double speed = velocity[0] - velocity[1], e = c.at("e");
    BOOST_TEST_CONTEXT(c.at("family") << " at " << speed << " m/s") {
      const double unsure = e > 0 ? 1 / (e * e) : 1;
      BOOST_TEST(std::abs(impact::restitution(pair, speed) - e) <= 1e-11 * unsure);
      const auto closed = impact::closed_restitution(pair, speed);
      closed_forms += closed.has_value();
      if (closed) BOOST_TEST(std::abs(*closed - e) <= 1e-13 * unsure);
    }
  }
  BOOST_TEST(closed_forms > 25);
}

// The root of a v (1 + e) = ln[(1 + a v)/(1 − a e v)], by 120 digits of mpmath.
BOOST_AUTO_TEST_CASE(closed_form_of_hunt_and_crossley_holds_at_all_speeds) {
  const std::pair<double, double> roots[] = {{1e-8, 0.99999999333333337778},
                                             {1e-5, 0.99999333337777745185},
                                             {1e-2, 0.9933774543987673634},
                                             {0.1, 0.93747557994990506377},
                                             {1, 0.59362426004004009232},
                                             {3, 0.30689679829096211452},
                                             {10, 0.099981624752943886879},
                                             {36, 0.027777777777777690077},
                                             {40, 0.024999999999999998398},
                                             {100, 0.01},
                                             {1e4, 1e-4},
                                             {1e8, 1e-8}};
  for (const auto& [speed, e] : roots) {
    const Pair pair{std::make_shared<contact::HuntCrossley>(1, 1, 1.5), 0.5};
    BOOST_TEST(impact::closed_restitution(pair, speed).value() == e, boost::test_tools::tolerance(1e-13));
  }
}

// exp(−2ζ arccos(ζ)/√(1−ζ²)) below ζ = 1, exp(−2ζ arcosh(ζ)/√(ζ²−1)) above, by 120 digits of mpmath.
BOOST_AUTO_TEST_CASE(closed_form_of_linear_damping_holds_at_all_ratios) {
  const std::pair<double, double> roots[] = {
      {1e-8, 0.99999996858407415758},  {0.5, 0.29843605919227488654},    {0.9999999, 0.13533530128131886776},
      {1, 0.13533528323661269189},     {10, 0.0024379340486363733667},   {1.0000001, 0.13533526519191000467},
      {1e4, 2.4999997649128204923e-9}, {1e8, 2.4999999999999953465e-17}, {1e12, 2.5e-25}};
  for (const auto& [ratio, e] : roots) {
    const Pair dashpot{contact::Viscoelastic{.stiffness = 1, .damping = 2 * ratio, .exponent = 1}, 1};
    const Pair tsuji{std::make_shared<contact::Tsuji>(1, std::sqrt(5.0) * ratio), 1};
    BOOST_TEST(impact::closed_restitution(dashpot, 1).value() == e, boost::test_tools::tolerance(1e-13));
    BOOST_TEST(impact::closed_restitution(tsuji, 1).value() == e, boost::test_tools::tolerance(1e-13));
  }
}

BOOST_AUTO_TEST_CASE(speeds_that_make_no_impact_are_refused) {
  const Pair beads{contact::Hertz{1}, 1};
  for (const double speed : {0.0, -1.0, infinity, std::nan("")}) {
    BOOST_CHECK_THROW(impact::restitution(beads, speed), InvalidParameter);
    BOOST_CHECK_THROW(impact::closed_restitution(beads, speed), InvalidParameter);
  }
}

BOOST_AUTO_TEST_CASE(curves_are_those_of_the_references) {
  for (const auto& curve : test::law_cases("restitution_curves.json")) {
    const Pair pair{test::law_of(curve.at("contact")), curve.at("mass")};
    for (std::size_t i = 0; i < curve.at("speed").size(); ++i) {
      const double e = impact::restitution(pair, curve.at("speed")[i]);
      const auto& expected = curve.at("e")[i];
      BOOST_TEST(std::abs(e - (expected.is_null() ? 0 : expected.get<double>())) <= 1e-9);
    }
  }
}

// Γ = c v^{1/5} k^{−3/5} m^{−2/5}: of a contact with k = m = v = 1 the damping itself.
BOOST_AUTO_TEST_CASE(kuwabara_kono_restitution_depends_on_one_group) {
  for (const auto& c : test::law_cases("kuwabara_kono.json")) {
    const Pair pair{contact::Viscoelastic{.stiffness = 1, .damping = c.at("group"), .exponent = 1.5}, 1};
    BOOST_TEST(std::abs(impact::restitution(pair, 1) - c.at("e").get<double>()) <= 1e-11);
  }
}

// The series of Ramírez et al. 1999 (Phys Rev E 60:4465) with what the end at f = 0 adds [Schwager & Pöschel
// 2008, PRE 78:051304]: e = 1 − C₁Γ + C₂Γ² − C₃Γ³ + C₄Γ⁴ + (4/15)Γ^{5/2} + O(Γ^{7/2}). Halving Γ must divide
// what is left by 2^{7/2}.
BOOST_AUTO_TEST_CASE(weak_damping_follows_the_series) {
  const double c1 = 1.153448858095289, c2 = 0.798266560944795, c3 = 0.522882568088415, c4 = 0.3487426752603;
  const auto rest = [&](double g) {
    const Pair pair{contact::Viscoelastic{.stiffness = 1, .damping = g, .exponent = 1.5}, 1};
    const double series = 1 - g * (c1 - g * (c2 - g * (c3 - g * c4))) + 4.0 / 15 * std::pow(g, 2.5);
    return impact::restitution(pair, 1) - series;
  };
  const double order = std::log2(rest(0.02) / rest(0.01));
  BOOST_TEST(std::abs(order - 3.5) < 0.1);
}

// e ~ v^{−1/4} far above yield [Johnson 1985, §11.5].
BOOST_AUTO_TEST_CASE(plastic_restitution_falls_with_the_fourth_root_of_the_speed) {
  const Pair pair{test::law_of({{"law", "thornton"},
                                {"effective_modulus", 1e11},
                                {"effective_radius", 0.005},
                                {"yield_pressure", 1e9}}),
                  0.02};
  const double slow = impact::restitution(pair, 100), fast = impact::restitution(pair, 1600);
  BOOST_TEST(slow / fast == 2, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(capture_velocities_are_those_of_the_references) {
  for (const auto& c : test::law_cases("capture_velocities.json")) {
    const Pair pair{test::law_of(c.at("contact")), c.at("mass")};
    const double expected = c.at("capture_velocity");
    const auto found = impact::capture_velocity(pair, 0.37, 1e-11);
    BOOST_TEST_REQUIRE(found.has_value());
    BOOST_TEST(std::abs(found->value() / expected - 1) <= 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(without_a_loss_nothing_is_captured) {
  const Pair dmt{test::law_of({{"law", "dmt"},
                               {"effective_modulus", 1e9},
                               {"effective_radius", 1e-5},
                               {"work_of_adhesion", 0.1}}),
                 1e-12};
  BOOST_TEST(!impact::capture_velocity(dmt, 1, 1e-6).has_value());
}
