#define BOOST_TEST_MODULE multiple - impact law
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/laws/multiple_impact_law.hpp"
#include "support/random_chains.hpp"
#include "support/random_configurations.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::impact;
using test::difference;
using test::Numbers;

namespace {

const auto to_rounding = boost::test_tools::tolerance(1e-12);

LawOutcome triplet(const Numbers& velocity, double icr, double e) {
  return multiple_impact(chain_configuration({1, 1, 1}, velocity),
                         {.direction = {icr, 1}, .energy_ratio = e});
}

/// The size P of the impulse by search alone: from the plastic point, where p·w = 0, upwards until the
/// energy is that of e. Empty if even there it is above.
std::optional<double> size_by_search(const Configuration& c, const Numbers& r, double e) {
  const auto velocity = [&](double size) {
    Numbers p = r, v = velocity_change(c, p);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = c.velocity[i] + size * v[i];
    return v;
  };
  const auto closing = [&](double size) {
    const auto w = gap_rates(c, velocity(size));
    return std::inner_product(r.begin(), r.end(), w.begin(), 0.0) < 0;
  };
  const auto poor = [&](double size) {
    return kinetic_energy(c, velocity(size)) < e * kinetic_energy(c, c.velocity);
  };
  const auto border = [](const auto& below, double low) {
    double high = std::max(1.0, 2 * low);
    while (below(high)) high *= 2;
    for (int i = 0; i < 200; ++i) (below((low + high) / 2) ? low : high) = (low + high) / 2;
    return low;
  };
  const double plastic = border(closing, 0);
  if (!poor(plastic)) return std::nullopt;
  return border(poor, plastic);
}

}  // namespace

BOOST_AUTO_TEST_CASE(elastic_triplets_of_known_ratio_part_as_known) {
  BOOST_TEST(difference(triplet({1, 0, 0}, 2, 1).velocity, {-1.0 / 3, 2.0 / 3, 2.0 / 3}) < 1e-15);
  BOOST_TEST(difference(triplet({1, 0, 0}, 1, 1).velocity, {0, 0, 1}) < 1e-15);
  const auto outcome = triplet({1, 0, -1}, 1, 1);
  BOOST_TEST(difference(outcome.velocity, {-1, 0, 1}) < 1e-15);
  BOOST_TEST((outcome.status == LawStatus::admissible));
}

// v = (1, 0, 0): 1/3 ≤ e ≤ 1 and (e − 3)/(2e − 2 − √(6e − 2)) ≤ α ≤ 2 [Acary 2003, eq. 18–19].
BOOST_AUTO_TEST_CASE(equal_triplet_is_admissible_within_the_bounds_of_the_paper_and_nowhere_else) {
  for (double e = 0.02; e <= 1; e += 0.02)
    for (double icr = 0.05; icr < 3; icr += 0.051) {
      BOOST_TEST_CONTEXT("e = " << e << ", icr = " << icr) {
        const bool real = e >= 1.0 / 3;
        const double least = real ? (e - 3) / (2 * e - 2 - std::sqrt(6 * e - 2)) : infinity;
        const bool inside = icr >= least && icr <= 2;
        BOOST_TEST((triplet({1, 0, 0}, icr, e).status == LawStatus::admissible) == inside);
      }
    }
  for (const double e : {0.4, 0.7, 1.0}) {
    const double least = (e - 3) / (2 * e - 2 - std::sqrt(6 * e - 2));
    const auto low = triplet({1, 0, 0}, least, e), high = triplet({1, 0, 0}, 2, e);
    BOOST_TEST(low.velocity[0] == low.velocity[1], to_rounding);
    BOOST_TEST(high.velocity[1] == high.velocity[2], to_rounding);
  }
}

BOOST_AUTO_TEST_CASE(law_agrees_with_a_search_for_general_velocities) {
  std::mt19937_64 random(20030512);
  std::uniform_real_distribution<double> unit(0, 1);
  int complex = 0, real = 0;
  for (int i = 0; i < 400; ++i) {
    const auto c = chain_configuration({0.1 + unit(random), 0.1 + unit(random), 0.1 + unit(random)},
                                       {unit(random), 2 * unit(random) - 1, -unit(random)});
    const LawParameters parameters{.direction = {unit(random), unit(random)}, .energy_ratio = unit(random)};
    const auto outcome = multiple_impact(c, parameters);
    if (outcome.status == LawStatus::no_impact) continue;
    const auto size = size_by_search(c, parameters.direction, parameters.energy_ratio);
    BOOST_TEST(size.has_value() == (outcome.status != LawStatus::complex));
    ++(size ? real : complex);
    if (size)
      BOOST_TEST(outcome.impulse[0] == *size * parameters.direction[0], boost::test_tools::tolerance(1e-7));
  }
  BOOST_TEST(complex > 20);
  BOOST_TEST(real > 20);
}

BOOST_AUTO_TEST_CASE(energy_and_momentum_hold_for_any_mass_matrix_and_contact_directions) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 300; ++i) {
    const auto c = test::random_configuration(random);
    Numbers r;
    for (std::size_t j = 0; j < c.contact.size(); ++j) r.push_back(unit(random));
    for (const auto frame : {EnergyFrame::given, EnergyFrame::mass_centre}) {
      const auto least = multiple_impact(c, {.direction = r, .frame = frame}).least_energy_ratio;
      const double e = 1 - unit(random) * (1 - least.value_or(0));
      const auto outcome = multiple_impact(c, {.direction = r, .energy_ratio = e, .frame = frame});
      if (outcome.status == LawStatus::no_impact) continue;
      const auto ratio = frame == EnergyFrame::given ? outcome.ratio_lab : outcome.ratio_centre;
      BOOST_TEST(*ratio == e, to_rounding);
      BOOST_TEST(test::momentum_residual(c, outcome.impulse, outcome.velocity) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(relative_energy_of_a_chain_is_that_relative_to_its_mass_centre) {
  const auto c = chain_configuration({1, 2, 3, 4}, {5, 3, -1, 7});
  const double centre = (1 * 5 + 2 * 3 + 3 * -1 + 4 * 7) / 10.0;
  auto relative = c.velocity;
  for (double& v : relative) v -= centre;
  BOOST_TEST(relative_energy(c, c.velocity) == kinetic_energy(c, relative), to_rounding);
}

BOOST_AUTO_TEST_CASE(energy_of_redundant_contacts_is_counted_once) {
  auto c = chain_configuration({1, 2, 3}, {1, 0, -1});
  const double once = relative_energy(c, c.velocity);
  c.contact.push_back(c.contact[0]);
  c.contact.push_back({{0, -1}, {2, 1}});
  BOOST_TEST(relative_energy(c, c.velocity) == once, to_rounding);
}

BOOST_AUTO_TEST_CASE(ratio_relative_to_the_mass_centre_does_not_depend_on_the_frame) {
  const LawParameters parameters{
      .direction = {1.4, 1}, .energy_ratio = 0.8, .frame = EnergyFrame::mass_centre};
  const auto rest = multiple_impact(chain_configuration({1, 1, 1}, {1, 0, 0}), parameters);
  const auto moving = multiple_impact(chain_configuration({1, 1, 1}, {8, 7, 7}), parameters);
  for (int i = 0; i < 3; ++i) BOOST_TEST(moving.velocity[i] - 7 == rest.velocity[i], to_rounding);
  BOOST_TEST(*moving.ratio_centre == 0.8, to_rounding);
  BOOST_TEST(std::abs(*moving.ratio_lab - 0.8) > 0.1);
}

BOOST_AUTO_TEST_CASE(every_inadmissible_class_is_reported_as_such) {
  const auto tensile = triplet({1, 0, 0}, -0.5, 1);
  BOOST_TEST((tensile.status == LawStatus::no_impact));  // r·w points apart
  const auto pulls = multiple_impact(chain_configuration({1, 1, 1}, {1, 0, 0}), {.direction = {1, -0.5}});
  BOOST_TEST((pulls.status == LawStatus::tensile_impulse));
  BOOST_TEST(*pulls.contact == 1);
  BOOST_TEST(reason(pulls) == "contact 2 would pull: its impulse is negative");
  const auto penetrates = triplet({1, 0, 0}, 2.5, 1);
  BOOST_TEST((penetrates.status == LawStatus::penetrating_velocity));
  BOOST_TEST(*penetrates.contact == 1);
  const auto complex = triplet({1, 0, 0}, 2, 0.3);
  BOOST_TEST((complex.status == LawStatus::complex));
  BOOST_TEST(complex.velocity.empty());
  BOOST_TEST(*complex.least_energy_ratio == 1.0 / 3, to_rounding);
  const auto apart = triplet({-1, 0, 1}, 1, 1);
  BOOST_TEST((apart.status == LawStatus::no_impact));
  BOOST_TEST(apart.velocity == Numbers({-1, 0, 1}), boost::test_tools::per_element());
  for (const auto& outcome : {tensile, penetrates, complex, apart}) BOOST_TEST(!reason(outcome).empty());
  BOOST_TEST(reason(triplet({1, 0, 0}, 1.5, 1)).empty());
}

BOOST_AUTO_TEST_CASE(at_the_least_energy_ratio_the_impact_is_plastic) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 100; ++i) {
    const auto c = test::random_configuration(random);
    const Numbers r(c.contact.size(), 1.0);
    for (const auto frame : {EnergyFrame::given, EnergyFrame::mass_centre}) {
      const auto least = multiple_impact(c, {.direction = r, .frame = frame}).least_energy_ratio;
      if (!least) continue;
      const auto plastic = multiple_impact(c, {.direction = r, .energy_ratio = *least, .frame = frame});
      BOOST_TEST_REQUIRE((plastic.status != LawStatus::complex));
      double power = 0, scale = 0;
      for (const double rate : gap_rates(c, plastic.velocity)) power += rate;
      for (const double rate : gap_rates(c, c.velocity)) scale += std::abs(rate);
      BOOST_TEST(std::abs(power) < 1e-6 * scale);  // a root of the rounding of e
    }
  }
}

BOOST_AUTO_TEST_CASE(walls_keep_their_velocity) {
  const auto outcome =
      multiple_impact(chain_configuration({infinity, 1, 2}, {0, -1, -1}), {.direction = {1.2, 0.1}});
  BOOST_TEST(outcome.velocity[0] == 0);
  BOOST_TEST(*outcome.ratio_lab == 1, to_rounding);
  const auto moving = chain_configuration({infinity, 1}, {1, 0});
  BOOST_CHECK_THROW(multiple_impact(moving, {.direction = {1}}), InvalidParameter);
  const auto struck = multiple_impact(moving, {.direction = {1}, .frame = EnergyFrame::mass_centre});
  BOOST_TEST(struck.velocity[1] == 2, to_rounding);
}

BOOST_AUTO_TEST_CASE(simulated_impacts_come_back_through_the_law) {
  std::mt19937_64 random(1671);
  ChainSolver solver;
  int undefined = 0, impacts = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto chain = test::random_chain(random, test::kinds[i % 2]);
    const auto& run = solver.solve(chain, {.accuracy = 1e-12});
    BOOST_TEST_REQUIRE((run.ending == hybrid::Ending::separated));
    const auto before = chain_configuration(chain.mass, chain.velocity);
    for (const auto& ratio : correlation_ratios(run.impulse)) undefined += !ratio;
    auto parameters = parameters_of(before, run.impulse, run.velocity, EnergyFrame::mass_centre);
    parameters.slow = 1e-11;
    const auto outcome = multiple_impact(before, parameters);
    const bool none = std::all_of(run.impulse.begin(), run.impulse.end(), [](double p) { return p == 0; });
    impacts += !none;
    BOOST_TEST_CONTEXT("chain " << i) {
      BOOST_TEST((outcome.status == (none ? LawStatus::no_impact : LawStatus::admissible)), reason(outcome));
      BOOST_TEST(difference(outcome.velocity, run.velocity) < 1e-12);
    }
  }
  BOOST_TEST(undefined > 100);
  BOOST_TEST(impacts > 900);
}

BOOST_AUTO_TEST_CASE(ratios_of_a_simulated_impact_lead_back_to_its_velocities) {
  for (const auto& c : test::cases("equal_chains.json")) {
    const auto chain = test::equal_chain(c.at("n"));
    const auto run = simulate(chain, {.accuracy = 1e-12});
    Numbers icr;
    for (const auto& ratio : run.icr) icr.push_back(*ratio);
    const LawParameters parameters{.direction = direction_of_ratios(icr),
                                   .energy_ratio = parameters_of(run).energy_ratio};
    const auto outcome = multiple_impact(chain_configuration(chain.mass, chain.velocity), parameters);
    BOOST_TEST(difference(outcome.velocity, c.at("final")) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(input_without_sense_is_refused) {
  const auto c = chain_configuration({1, 1, 1}, {1, 0, 0});
  BOOST_CHECK_THROW(multiple_impact(c, {.direction = {1}}), InvalidParameter);
  BOOST_CHECK_THROW(multiple_impact(c, {.direction = {1, std::nan("")}}), InvalidParameter);
  BOOST_CHECK_THROW(multiple_impact(c, {.direction = {1, 1}, .energy_ratio = -0.1}), InvalidParameter);
  BOOST_CHECK_THROW(direction_of_ratios({infinity}), InvalidParameter);
  const Configuration singular{.mass = {1, 1, 1, 1}, .contact = {{{0, 1}}}, .velocity = {1, 0}};
  BOOST_CHECK_THROW(validate(singular), InvalidParameter);
  BOOST_CHECK_THROW(validate(chain_configuration({1, -1}, {1, 0})), InvalidParameter);
  BOOST_CHECK_THROW(validate(chain_configuration({1, 1, 1}, {1, 0})), InvalidParameter);
}
