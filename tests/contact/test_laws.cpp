#define BOOST_TEST_MODULE contact laws
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/hertz.hpp"
#include "mariotte/contact/hunt_crossley.hpp"
#include "mariotte/contact/law.hpp"
#include "mariotte/contact/tabulated.hpp"
#include "mariotte/contact/tsuji.hpp"
#include "mariotte/core/error.hpp"

using namespace mariotte::contact;
using mariotte::Scale;

namespace {

/// f = 3 δ² as somebody else would write it.
class Quadratic final : public CustomLaw {
 public:
  std::string_view name() const override { return "quadratic"; }
  Force force(double d, double) const override { return {3 * d * d, 6 * d, 0}; }
  double stored_energy(double d) const override { return d * d * d; }
};

/// f = 3 δ² (1 + δ̇/2).
class Damped final : public CustomLaw {
 public:
  std::string_view name() const override { return "damped"; }
  Force force(double d, double w) const override {
    return {3 * d * d * (1 + 0.5 * w), 6 * d * (1 + 0.5 * w), 1.5 * d * d};
  }
  double stored_energy(double d) const override { return d * d * d; }
  bool dissipates() const override { return true; }
};

/// Any law as one that somebody else wrote.
class Any final : public CustomLaw {
 public:
  explicit Any(Law law) : law_(std::move(law)) {}
  std::string_view name() const override { return "any"; }
  Force force(double d, double w) const override { return smooth_force(law_, d, w); }
  double stored_energy(double d) const override { return mariotte::contact::stored_energy(law_, d); }

 private:
  Law law_;
};

/// One of each: a new law's entry here covers it.
const std::vector<Law> laws = {Linear{3.0},
                               Hertz{3.0},
                               PowerLaw{.stiffness = 3.0, .damping = 0.4, .exponent = 1.7},
                               std::make_shared<HuntCrossley>(3.0, 0.4, 1.7),
                               std::make_shared<Tsuji>(3.0, 0.4),
                               std::make_shared<Tabulated>(std::vector<LawPoint>{{0.1, 1}, {0.2, 4}, {1, 9}}),
                               std::make_shared<Quadratic>(),
                               std::make_shared<Damped>()};

const auto every_law = boost::unit_test::data::xrange(laws.size());

constexpr double indentations[] = {1e-6, 0.01, 0.3, 2.0};
constexpr double rates[] = {-0.5, -1e-3, 0.0, 0.2, 3.0};

template <class Visit>
void for_each_state(Visit&& visit) {
  for (const double indentation : indentations)
    for (const double rate : rates) visit(indentation, rate);
}

}  // namespace

BOOST_DATA_TEST_CASE(slopes_agree_with_differences, every_law) {
  const Law& law = laws[sample];
  for_each_state([&](double d, double w) {
    const auto f = force(law, d, w);
    const double h = 1e-5 * d, g = 1e-5;
    if (force(law, d - h, w - g).value == 0) return;  // the kink where the force is cut off
    const double by_indentation = (force(law, d + h, w).value - force(law, d - h, w).value) / (2 * h);
    const double by_rate = (force(law, d, w + g).value - force(law, d, w - g).value) / (2 * g);
    BOOST_TEST(std::abs(f.by_indentation - by_indentation) <= 1e-7 * (1 + std::abs(by_indentation)));
    BOOST_TEST(std::abs(f.by_rate - by_rate) <= 1e-7 * (1 + std::abs(by_rate)));
  });
}

BOOST_DATA_TEST_CASE(a_contact_never_pulls, every_law) {
  for_each_state([&](double d, double w) { BOOST_TEST(force(laws[sample], d, w).value >= 0); });
}

BOOST_DATA_TEST_CASE(force_is_zero_at_first_touch_without_approach, every_law) {
  BOOST_TEST(force(laws[sample], 0, 0).value == 0);
}

BOOST_DATA_TEST_CASE(stored_energy_is_the_integral_of_the_static_force, every_law) {
  const Law& law = laws[sample];
  for (const double d : indentations) {
    const double h = 1e-5 * d;
    const double slope = (stored_energy(law, d + h) - stored_energy(law, d - h)) / (2 * h);
    BOOST_TEST(slope == force(law, d, 0).value, boost::test_tools::tolerance(1e-8));
  }
}

BOOST_DATA_TEST_CASE(damping_never_gives_energy, every_law) {
  const Law& law = laws[sample];
  for_each_state([&](double d, double w) {
    const double lost = (force(law, d, w).value - force(law, d, 0).value) * w;
    BOOST_TEST(lost >= 0);
    BOOST_TEST(!dissipates(law) == (lost == 0 && force(law, d, 1).value == force(law, d, 0).value));
  });
}

BOOST_DATA_TEST_CASE(the_load_has_the_sign_of_the_force, every_law) {
  for_each_state([&](double d, double w) {
    BOOST_TEST((load(laws[sample], d, w).value > 0) == (smooth_force(laws[sample], d, w).value > 0));
  });
}

BOOST_DATA_TEST_CASE(a_law_in_other_units_is_the_same_law, every_law) {
  const Law& law = laws[sample];
  const Scale scale{.mass = 4, .velocity = 0.5, .length = 0.25, .time = 0.5};
  const auto other = in_units(std::make_shared<Any>(law), scale);
  for_each_state([&](double d, double w) {
    const auto own = smooth_force(law, d, w);
    const auto f = smooth_force(*other, d / scale.length, w / scale.velocity);
    const double eps = 1e-15 * (1 + std::abs(own.by_indentation));
    BOOST_TEST(std::abs(f.value * scale.force() - own.value) <= eps);
    BOOST_TEST(std::abs(f.by_indentation * scale.force() / scale.length - own.by_indentation) <= eps);
    BOOST_TEST(std::abs(f.by_rate * scale.force() / scale.velocity - own.by_rate) <= eps);
    BOOST_TEST(other->stored_energy(d / scale.length) * scale.energy() == stored_energy(law, d),
               boost::test_tools::tolerance(1e-15));
  });
}

BOOST_AUTO_TEST_CASE(an_indentation_stores_its_energy_and_carries_its_force) {
  for (const double size : {1e-30, 1e-3, 1.0, 1e20}) {
    const Quadratic law;
    BOOST_TEST(law.natural_indentation(size) == std::cbrt(size), boost::test_tools::tolerance(1e-13));
    BOOST_TEST(find_static_indentation(law, size).value() == std::sqrt(size / 3),
               boost::test_tools::tolerance(1e-13));
  }
}

BOOST_AUTO_TEST_CASE(a_law_that_does_not_grow_is_refused) {
  class Limp final : public CustomLaw {
    std::string_view name() const override { return "limp"; }
    Force force(double, double) const override { return {1, 0, 0}; }
    double stored_energy(double) const override { return 1; }
  };
  BOOST_CHECK_THROW(Limp().natural_indentation(2), mariotte::InvalidParameter);
}

/// Stores δ²/2.
class Stated final : public CustomLaw {
 public:
  Stated(double slope, bool dissipates) : slope_(slope), dissipates_(dissipates) {}
  std::string_view name() const override { return "stated"; }
  Force force(double depth, double) const override { return {slope_ * depth, slope_, 0}; }
  double stored_energy(double depth) const override { return 0.5 * depth * depth; }
  bool dissipates() const override { return dissipates_; }

 private:
  double slope_;
  bool dissipates_;
};

BOOST_AUTO_TEST_CASE(a_force_without_sense_is_refused_by_the_name_of_its_law) {
  const auto refused = [](double slope, std::string_view why) {
    BOOST_CHECK_EXCEPTION(Stated(slope, false).natural_indentation(2), mariotte::InvalidParameter,
                          [&](const auto& error) { return error.what() == why; });
  };
  refused(std::nan(""), "the law 'stated' at δ = 2 m: its force is no number");
  refused(
      -1,
      "the law 'stated' at δ = 2 m: its force does not push, though it stores more energy the deeper it is");
  refused(2, "the law 'stated' at δ = 2 m: its force is 4 N, and the slope of its stored energy 2 N");
  BOOST_TEST(Stated(1, false).natural_indentation(2) == 2, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(Stated(2, true).natural_indentation(2) == 2, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(only_power_laws_have_an_exponent) {
  const Law power = Hertz{3}, other = std::make_shared<Quadratic>();
  BOOST_TEST(exponent(power) == 1.5);
  BOOST_TEST(!power_law(other));
  BOOST_CHECK_THROW(exponent(other), mariotte::InvalidParameter);
  BOOST_CHECK_THROW(stiffness(other), mariotte::InvalidParameter);
  BOOST_CHECK_THROW(damping(other), mariotte::InvalidParameter);
}

BOOST_AUTO_TEST_CASE(viscoelastic_force_is_zero_in_a_withdrawing_contact) {
  const Viscoelastic law{.stiffness = 1, .damping = 2, .exponent = 1.5};
  BOOST_TEST(force(law, 0.1, -1).value == 0);
  BOOST_TEST(force(law, 0.1, -0.04).value > 0);
}

BOOST_AUTO_TEST_CASE(viscoelastic_without_damping_is_linear_or_hertz) {
  BOOST_TEST(force(Viscoelastic{.stiffness = 2, .damping = 0, .exponent = 1}, 0.3, 1).value ==
             force(Linear{2}, 0.3, 1).value);
  BOOST_TEST(force(Viscoelastic{.stiffness = 2, .damping = 0, .exponent = 1.5}, 0.3, 1).value ==
                 force(Hertz{2}, 0.3, 1).value,
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(hertz_stiffness_of_two_equal_spheres) {
  // (4/3) · E/(2(1−ν²)) · √(R/2)
  const Elasticity steel{.young = 210e9, .poisson = 0.3};
  const double expected = 4.0 / 3.0 * 210e9 / (2 * (1 - 0.09)) * std::sqrt(0.005);
  BOOST_TEST(hertz_stiffness(steel, 0.01, steel, 0.01) == expected, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(hertz_stiffness_against_a_rigid_plane) {
  const Elasticity glass{.young = 48e9, .poisson = 0.2}, rigid{.young = HUGE_VAL, .poisson = 0};
  const double expected = 4.0 / 3.0 * 48e9 / (1 - 0.04) * std::sqrt(0.01);
  BOOST_TEST(hertz_stiffness(glass, 0.01, rigid, HUGE_VAL) == expected, boost::test_tools::tolerance(1e-14));
}
