// Laws that yield, adhere and remember: what each statement promises the automaton.
#define BOOST_TEST_MODULE branched laws
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/brach_dunn_law.hpp"
#include "mariotte/contact/dmt.hpp"
#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/thornton.hpp"
#include "mariotte/contact/thornton_ning.hpp"
#include "mariotte/contact/uncut.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/core/error.hpp"

using namespace mariotte::contact;
using mariotte::InvalidParameter;
using mariotte::Scale;

namespace {

/// One of each: a new law's entry here covers it.
const std::vector<Law> laws = {state(WaltonBraun(1, 3)),
                               state(Thornton(1, 1, 0.2)),
                               state(ThorntonNing(1, 1, 0.2, 0.002)),
                               state(Jkr(1, 1, 0.002, 0.1)),
                               state(Dmt(1, 1, 0.002, 0.1)),
                               state(BrachDunnLaw(1, 1, 0.002, 0.1, 0.2)),
                               std::make_shared<Uncut>(Law(PowerLaw{.stiffness = 3, .damping = 0.4}))};
const auto every_law = boost::unit_test::data::xrange(laws.size());

const BranchedLaw& law_at(std::size_t i) {
  return *branched(laws[i]);
}

/// A past on every branch that the law has.
std::vector<Memory> pasts(const BranchedLaw& law) {
  const double limit = law.yield_indentation({});
  std::vector<Memory> all;
  if (limit > 0) all.push_back({});
  if (!std::isfinite(limit)) return all;
  all.push_back({.branch = Branch::plastic});
  all.push_back({.branch = Branch::unloading, .peak = 0.5 + 2 * limit});
  return all;
}

/// Indentations at which a contact with that past can be.
std::vector<double> indentations(const BranchedLaw& law, const Memory& past) {
  const double limit = law.yield_indentation({});
  if (past.branch == Branch::plastic) return {1.1 * limit + 0.01, 2 * limit + 1};
  const double from = law.opening_indentation(past);
  const double to = past.peak > 0 ? past.peak : std::isfinite(limit) ? limit : from + 1;
  return {from + 0.01 * (to - from), from + 0.3 * (to - from), from + 0.9 * (to - from)};
}

template <class Visit>
void for_each_state(const BranchedLaw& law, Visit&& visit) {
  for (const auto& past : pasts(law))
    for (const double d : indentations(law, past)) visit(past, d);
}

}  // namespace

// Central differences of step h lose h² f'''/6 and ε f/h: 1e-6 for the strongest curvature, at detachment.
BOOST_DATA_TEST_CASE(slopes_agree_with_differences, every_law) {
  const auto& law = law_at(sample);
  for_each_state(law, [&](const Memory& past, double d) {
    for (const double w : {-0.3, 0.0, 0.2}) {
      const double h = 1e-6;
      const auto f = law.force(past, d, w);
      const double by_indentation =
          (law.force(past, d + h, w).value - law.force(past, d - h, w).value) / (2 * h);
      const double by_rate = (law.force(past, d, w + h).value - law.force(past, d, w - h).value) / (2 * h);
      BOOST_TEST(std::abs(f.by_indentation - by_indentation) <= 1e-5 * (1 + std::abs(by_indentation)));
      BOOST_TEST(std::abs(f.by_rate - by_rate) <= 1e-8 * (1 + std::abs(by_rate)));
    }
  });
}

BOOST_DATA_TEST_CASE(stored_energy_is_the_integral_of_the_force_off_the_plastic_branch, every_law) {
  const auto& law = law_at(sample);
  for_each_state(law, [&](const Memory& past, double d) {
    if (past.branch == Branch::plastic) return;
    const double h = 1e-5 * (d - law.opening_indentation(past));
    const double slope = (law.stored_energy(past, d + h) - law.stored_energy(past, d - h)) / (2 * h);
    const double f = law.force(past, d, 0).value;
    BOOST_TEST(std::abs(slope - f) <= 1e-7 * (1 + std::abs(f)));
  });
}

/// What flows with closed forms and series follow is the law's own force, in other units as well.
BOOST_DATA_TEST_CASE(a_branch_that_is_a_power_or_a_polynomial_has_the_force_of_its_law, every_law) {
  const auto other_units = in_units(law_at(sample), std::get<SharedLaw>(laws[sample]),
                                    Scale{.mass = 2, .velocity = 0.5, .length = 0.3, .time = 0.6});
  for (const auto* law : {&law_at(sample), other_units->branched()})
    for_each_state(*law, [&](const Memory& past, double d) {
      const double rate = -0.2, f = law->force(past, d, rate).value;
      if (const auto power = law->power(past)) {
        const double depth = d - power->origin, n = power->exponent;
        const double width = std::pow(depth, damping_exponent(power->grows, n));
        const double g = power->stiffness * std::pow(depth, n) + power->damping * width * rate - power->pull;
        BOOST_TEST(std::abs(g - f) <= 1e-13 * (1 + std::abs(f)));
      }
      if (const auto branch = law->width_branch(past)) {
        const double u = branch->curve.root(d);
        double g = branch->damping * u * u * rate, power = 1;
        for (const double push : branch->push) g += push * power, power *= u;
        BOOST_TEST(std::abs(branch->curve.indentation(u) - d) <= 1e-14 * (1 + std::abs(d)));
        BOOST_TEST(std::abs(g - f) <= 1e-13 * (1 + std::abs(f)));
      }
    });
}

/// The two indentations that laws may know by formulas.
BOOST_DATA_TEST_CASE(at_its_natural_indentation_it_stores_the_energy_and_at_rest_it_has_no_force, every_law) {
  const auto other_units = in_units(law_at(sample), std::get<SharedLaw>(laws[sample]),
                                    Scale{.mass = 2, .velocity = 0.5, .length = 0.3, .time = 0.6});
  for (const auto* law : {&law_at(sample), other_units->branched()}) {
    for (const double energy : {1e-6, 0.01, 0.3, 40.0}) {
      const double depth = law->natural_indentation(energy);
      BOOST_TEST(depth > 0);
      BOOST_TEST(std::abs(law->stored_energy(depth) - energy) <=
                 1e-12 * (energy + law->stored_energy(2 * depth)));
    }
    for (const auto& past : pasts(*law))
      if (const auto rest = law->rest_indentation(past)) {
        const auto f = law->force(past, *rest, 0);
        BOOST_TEST(std::abs(f.value) <= 1e-13 * f.by_indentation * *rest);
        BOOST_TEST(law->force(past, 1.01 * *rest, 0).value > 0);
      }
  }
}

/// What the plastic branch takes up is stored or lost.
BOOST_DATA_TEST_CASE(plastic_work_is_what_is_not_stored, every_law) {
  const auto& law = law_at(sample);
  BOOST_TEST(law.plastic_loss(0) == 0);
  if (!std::isfinite(law.yield_indentation({}))) return;
  const Memory past{.branch = Branch::plastic};
  for (const double d : indentations(law, past)) {
    const double h = 1e-5 * d;
    const auto taken = [&](double at) { return law.stored_energy(past, at) + law.plastic_loss(at); };
    const double f = law.force(past, d, 0).value;
    BOOST_TEST(std::abs((taken(d + h) - taken(d - h)) / (2 * h) - f) <= 1e-7 * (1 + std::abs(f)));
    BOOST_TEST(law.plastic_loss(d + h) > law.plastic_loss(d));
  }
}

BOOST_DATA_TEST_CASE(branches_join_without_a_jump, every_law) {
  const auto& law = law_at(sample);
  const double limit = law.yield_indentation({});
  BOOST_TEST(limit >= 0);
  if (!std::isfinite(limit)) return;
  const Memory plastic{.branch = Branch::plastic};
  const double at_limit = law.force(plastic, limit, 0).value;
  if (limit > 0) BOOST_TEST(std::abs(law.force(Memory{}, limit, 0).value - at_limit) <= 1e-14);
  BOOST_TEST(std::abs(law.plastic_loss(limit)) <= 1e-15);
  const double peak = 2 * limit + 0.5;
  const Memory unloading{.branch = Branch::unloading, .peak = peak};
  BOOST_TEST(law.force(unloading, peak, 0).value == law.force(plastic, peak, 0).value,
             boost::test_tools::tolerance(1e-13));
  BOOST_TEST(law.yield_indentation(unloading) == peak);
}

BOOST_DATA_TEST_CASE(a_law_in_other_units_is_the_same_law, every_law) {
  const auto& law = law_at(sample);
  const Scale scale{.mass = 4, .velocity = 0.5, .length = 0.3, .time = 0.6};
  const auto scaled = in_units(std::get<SharedLaw>(laws[sample]), scale);
  const auto& other = *scaled->branched();
  for_each_state(law, [&](const Memory& past, double d) {
    auto same = past;
    same.peak /= scale.length;
    const auto own = law.force(past, d, 0.2), f = other.force(same, d / scale.length, 0.2 / scale.velocity);
    const auto close = [](double a, double b) { return std::abs(a - b) <= 1e-13 * (1 + std::abs(b)); };
    BOOST_TEST(close(f.value * scale.force(), own.value));
    BOOST_TEST(close(f.by_rate * scale.force() / scale.velocity, own.by_rate));
    BOOST_TEST(close(other.opening_indentation(same) * scale.length, law.opening_indentation(past)));
    BOOST_TEST(close(other.closing_indentation(same) * scale.length, law.closing_indentation(past)));
    BOOST_TEST(
        close(other.stored_energy(same, d / scale.length) * scale.energy(), law.stored_energy(past, d)));
  });
}

// [Johnson, Kendall & Roberts 1971]: the points of the curve in closed form.
BOOST_AUTO_TEST_CASE(a_jkr_contact_snaps_in_and_lets_go_where_it_should) {
  const double e = 1.3e9, r = 5e-6, w = 0.05, pi = std::numbers::pi;
  const auto law = state(Jkr(e, r, w, 0));
  const auto& jkr = *branched(law);
  const auto close = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(jkr.force({}, 0, 0).value == -4.0 / 3.0 * pi * w * r, close);
  const double a3 = pi * w * r * r / (8 * e), end = -3 * std::cbrt(a3 * a3) / r;
  BOOST_TEST(jkr.opening_indentation({}) == end, close);
  BOOST_TEST(jkr.force({}, end, 0).value == -5.0 / 6.0 * pi * w * r, close);
  const double a0 = std::cbrt(9 * pi * w * r * r / (2 * e));
  BOOST_TEST(std::abs(jkr.force({}, a0 * a0 / (3 * r), 0).value) < 1e-12 * w * r);
  const double lost = jkr.stored_energy({}, end) - jkr.stored_energy({}, 0);
  const double factor = (3.2 + 0.3 * std::pow(4, 10.0 / 3)) * std::pow(pi / 8, 5.0 / 3);
  BOOST_TEST(lost == factor * std::cbrt(std::pow(w, 5) * std::pow(r, 4) / (e * e)), close);
}

// From a yield at u³ = 5/4 s R on the loss grows from the start; where a contact yields earlier the law
// gains.
BOOST_AUTO_TEST_CASE(a_dent_never_costs_less_than_nothing) {
  constexpr double work = 0.01;
  const double s = std::sqrt(2 * std::numbers::pi * work);
  const auto pressure = [&](double u) { return 2 / std::numbers::pi * (u * u - s / (2 * u)); };
  const double least = std::cbrt(1.25 * s);
  const ThorntonNing early(1, 1, pressure(0.96 * least), work);
  BOOST_TEST(early.plastic_loss(early.curve.indentation(1.02 * early.yield_root)) < 0);
  for (const double later : {1.001, 1.01, 1.1, 2.0}) {
    const ThorntonNing law(1, 1, pressure(later * least), work);
    for (double deeper = 1.001, before = 0; deeper < 2; deeper *= 1.05) {
      const double loss = law.plastic_loss(law.curve.indentation(deeper * law.yield_root));
      BOOST_TEST(loss > before);
      before = loss;
    }
  }
}

BOOST_AUTO_TEST_CASE(numbers_without_sense_are_refused) {
  BOOST_CHECK_THROW(WaltonBraun(2, 1), InvalidParameter);
  BOOST_CHECK_THROW(WaltonBraun(0, 1), InvalidParameter);
  BOOST_CHECK_THROW(Thornton(1, 1, std::nan("")), InvalidParameter);
  BOOST_CHECK_THROW(Jkr(1, 1, 0, 0), InvalidParameter);
  BOOST_CHECK_THROW(Jkr(1, 1, 0.1, -1), InvalidParameter);
  BOOST_CHECK_THROW(Dmt(1, -1, 0.1, 0), InvalidParameter);
  BOOST_CHECK_THROW(BrachDunnLaw(1, 1, 0.1, -1, 0), InvalidParameter);
  BOOST_CHECK_THROW(ThorntonNing(1, 1, 1e-6, 0.01), InvalidParameter);  // yields as it snaps in
}
