// Slopes of one outcome of a row by all its numbers, swept back: against slopes that run forward, and against
// what units and time demand.
#define BOOST_TEST_MODULE adjoint
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"

using namespace mariotte;
namespace tt = boost::test_tools;

namespace {

using contact::PowerLaw;

constexpr hybrid::Options usual{.accuracy = 1e-10};

/// Balls of several masses, struck by the first.
model::Chain row_of(std::vector<contact::Law> laws, std::vector<double> gaps) {
  model::Chain row{.mass = {}, .law = std::move(laws), .gap = std::move(gaps), .velocity = {}};
  for (std::size_t i = 0; i <= row.law.size(); ++i) {
    row.mass.push_back(1 + 0.3 * std::sin(2.0 * static_cast<double>(i)));
    row.velocity.push_back(i == 0 ? 1 : 0);
  }
  return row;
}

impact::Adjoint swept(const model::Chain& row, std::size_t ball, const hybrid::Options& options = usual) {
  std::vector<double> weights(row.mass.size());
  weights[ball] = 1;
  return impact::adjoint(row, weights, options);
}

/// Largest difference of the slopes of a velocity from those that run forward, by all parameters.
double difference(const model::Chain& row, std::size_t ball, const hybrid::Options& options,
                  const hybrid::Options& ahead) {
  const auto forward = impact::sensitivity(row, impact::parameters(row), ahead);
  const auto& outcome = forward.outcome.at(ball);
  const auto back = as_sensitivity(row, swept(row, ball, options), outcome.name, outcome.index);
  BOOST_TEST_REQUIRE(back.parameter.size() == forward.parameter.size());
  BOOST_TEST(name(back.ending) == name(forward.ending));
  BOOST_TEST(std::abs(*back.outcome[0].value - *outcome.value) < 1e-10);
  double most = 0;
  for (std::size_t c = 0; c < back.parameter.size(); ++c) {
    BOOST_TEST(back.parameter[c].name == forward.parameter[c].name);
    most = std::max(most, std::abs(back.outcome[0].slope[c].value() - outcome.slope[c].value()));
  }
  return most;
}

double worst(const model::Chain& row, const hybrid::Options& options, const hybrid::Options& ahead) {
  double most = 0;
  for (std::size_t ball = 0; ball < row.mass.size(); ++ball)
    most = std::max(most, difference(row, ball, options, ahead));
  return most;
}

double worst(const model::Chain& row, const hybrid::Options& options = usual) {
  return worst(row, options, options);
}

const std::vector<contact::Law> hertz(4, contact::Hertz(1));
const std::vector<double> touching(4, 0.0), apart = {0.1, 0, 0.02, 0.3};

}  // namespace

BOOST_AUTO_TEST_CASE(slopes_of_hertz_rows_are_those_that_run_forward) {
  BOOST_TEST(worst(row_of(hertz, touching)) < 1e-9);
  BOOST_TEST(worst(row_of(hertz, apart)) < 1e-10);
}

BOOST_AUTO_TEST_CASE(slopes_of_rows_of_any_power_laws_are_those_that_run_forward) {
  const std::vector<std::vector<contact::Law>> all = {
      {contact::Linear(1), contact::Linear(2), contact::Linear(1.5)},
      {PowerLaw{1, 0.1, 1}, PowerLaw{2, 0.2, 1}, PowerLaw{1, 0.05, 1}},
      {PowerLaw{1, 0.1, 1.5}, PowerLaw{2, 0.2, 1.5}, PowerLaw{1, 0.05, 1.5}},
      {PowerLaw{1, 0, 2}, PowerLaw{2, 0, 1.3}, PowerLaw{1, 0.1, 2.5}}};
  for (const auto& laws : all)
    for (const auto& gaps : {std::vector<double>(3, 0.0), std::vector<double>{0.1, 0.2, 0.03}})
      BOOST_TEST(worst(row_of(laws, gaps)) < 1e-9);
}

// The slope by an exponent has ∫ f μ ln δ dt, and a damper pushes from δ = 0 on.
BOOST_AUTO_TEST_CASE(slopes_by_exponents_of_dampers_that_begin_are_exact) {
  const auto row =
      row_of({PowerLaw{1, 0.1, 1.5}, PowerLaw{2, 0.2, 1.5}, PowerLaw{1, 0.05, 1.5}}, {0.1, 0.2, 0.03});
  for (const double accuracy : {1e-8, 1e-10})
    BOOST_TEST(worst(row, {.accuracy = accuracy}, {.accuracy = 1e-12}) < 1e-10);
}

// δ² ln δ is smooth neither where the contact begins nor where it ends.
BOOST_AUTO_TEST_CASE(slopes_by_exponents_of_contacts_that_begin_and_end_are_exact) {
  const auto row = row_of({PowerLaw{1, 0, 2}, PowerLaw{2, 0, 1.3}, PowerLaw{1, 0.1, 2.5}}, {0.1, 0.2, 0.03});
  for (const double accuracy : {1e-9, 3e-10})
    BOOST_TEST(worst(row, {.accuracy = accuracy}, {.accuracy = 1e-12}) < 2e-10);
}

// Linear contacts behind Hertz contacts are hardly pressed for long, and act from the hit on all the same.
BOOST_AUTO_TEST_CASE(slopes_of_mixed_rows_that_touch_are_those_that_run_forward) {
  const auto row =
      row_of({contact::Hertz(5), contact::Linear(0.4), contact::Hertz(3), contact::Linear(10)}, touching);
  for (const double accuracy : {1e-8, 1e-10}) BOOST_TEST(worst(row, {.accuracy = accuracy}) < 30 * accuracy);
}

BOOST_AUTO_TEST_CASE(light_balls_with_strong_dampers_have_slopes) {
  for (const double exponent : {1.0, 1.5}) {
    const PowerLaw law{0.3, 1, exponent};
    auto row = row_of({law, law, law, law}, apart);
    for (double& mass : row.mass) mass *= 0.1;
    BOOST_TEST(worst(row) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(walls_and_units_do_no_harm) {
  auto row = row_of(hertz, apart);
  row.mass.back() = infinity;
  BOOST_TEST(worst(row) < 1e-9);
  for (double& mass : row.mass) mass *= 3e-3;
  for (double& speed : row.velocity) speed *= 20;
  for (auto& law : row.law) law = PowerLaw{1e4, 0, 1.4};
  const auto by = impact::parameters(row);
  const auto back = as_sensitivity(row, swept(row, 1), "velocity", 1).outcome[0];
  const auto forward = impact::sensitivity(row, by, usual).outcome[1];
  for (std::size_t c = 0; c < by.size(); ++c)
    BOOST_TEST(std::abs(*back.slope[c] - forward.slope[c].value()) * by[c].value < 1e-9 * 20, by[c].name);
}

BOOST_AUTO_TEST_CASE(a_run_may_end_while_contacts_push) {
  auto options = usual;
  options.max_time = 2;
  BOOST_TEST(worst(row_of(hertz, touching), options) < 1e-9);
}

BOOST_AUTO_TEST_CASE(rows_that_start_indented_have_slopes) {
  auto row = row_of(hertz, {-0.1, -0.05, 0.02, -0.2});
  row.precompressed = true;
  row.velocity[0] = 0;
  BOOST_TEST(worst(row) < 1e-9);
}

BOOST_AUTO_TEST_CASE(weights_add_outcomes_up) {
  const auto row = row_of(hertz, apart);
  const auto sum = impact::adjoint(row, std::vector<double>{1, 0, 0, -2, 0}, usual);
  const auto first = swept(row, 0), fourth = swept(row, 3);
  BOOST_TEST(std::abs(sum.value - (first.value - 2 * fourth.value)) < 1e-14);
  for (std::size_t j = 0; j < 4; ++j)
    BOOST_TEST(std::abs(sum.slopes.gap[j] - (first.slopes.gap[j] - 2 * fourth.slopes.gap[j])) < 1e-13);
}

// Three slopes that run forward; and what other units and another start of the clock must not change.
BOOST_AUTO_TEST_CASE(slopes_of_a_long_row_are_right) {
  constexpr std::size_t balls = 100;
  auto row = row_of(std::vector<contact::Law>(balls - 1, contact::Hertz(1)), std::vector<double>(balls - 1));
  for (std::size_t j = 50; j < 60; ++j) row.gap[j] = 0.1;
  const auto back = swept(row, balls - 1);
  auto by = impact::parameters(row);
  const auto is_other = [](const auto& one) {
    return one.name != "mass[20]" && one.name != "gap[55]" && one.name != "contact[90].stiffness";
  };
  std::erase_if(by, is_other);
  const auto forward = impact::sensitivity(row, by, usual).outcome[balls - 1];
  const auto& slopes = back.slopes;
  const double found[] = {slopes.mass[20], slopes.gap[55], slopes.stiffness[90]};
  for (std::size_t c = 0; c < 3; ++c) BOOST_TEST(std::abs(found[c] - forward.slope[c].value()) < 1e-9);
  double by_units = 0, by_time = 0, size = 0;
  for (std::size_t i = 0; i < balls; ++i) by_units += slopes.mass[i] * row.mass[i];
  for (std::size_t j = 0; j + 1 < balls; ++j) {
    by_units += slopes.stiffness[j];
    by_time += slopes.gap[j] * (row.velocity[j + 1] - row.velocity[j]);
    size += std::abs(slopes.stiffness[j]);
  }
  BOOST_TEST(size > 0.1);
  BOOST_TEST(std::abs(by_units) < 1e-10);
  BOOST_TEST(std::abs(by_time) < 1e-10);
}

// Those at the front are pressed from the hit on.
BOOST_AUTO_TEST_CASE(linear_contacts_that_wait_for_the_wave_have_no_slopes_on_both_sides) {
  const auto row = row_of(std::vector<contact::Law>(59, contact::Linear(1)), std::vector<double>(59));
  const auto all = swept(row, 59);
  BOOST_TEST(!std::isnan(all.slopes.gap[5]));
  BOOST_TEST(std::isnan(all.slopes.gap[40]));
  BOOST_TEST(worst(row_of({contact::Linear(1), contact::Linear(2), contact::Linear(1.5)}, {0.1, 0, 0})) <
             1e-9);
  BOOST_TEST(std::isnan(all.slopes.velocity[41]));
  BOOST_TEST(!std::isnan(all.slopes.mass[41]));
  const auto told = as_sensitivity(row, all, "velocity", 59);
  BOOST_TEST(told.notes.size() == 1U);
  const impact::Parameter<model::Chain> mass{"mass[41]", row.mass[41], 0.01,
                                             [&](double value, model::Chain& moved) {
                                               moved = row;
                                               moved.mass[41] = value;
                                             }};
  BOOST_TEST(std::abs(slope_by(all.slopes, mass) / all.slopes.mass[41] - 1) < 1e-10);
}

// What a contact near the edge of the first island would pass on at once is not there yet.
BOOST_AUTO_TEST_CASE(linear_contacts_near_the_edge_of_an_island_have_right_slopes_or_none) {
  const auto row = row_of(std::vector<contact::Law>(59, contact::Linear(1)), std::vector<double>(59));
  const hybrid::Options until{.accuracy = 1e-8, .max_time = 50};
  auto by = impact::parameters(row);
  std::erase_if(by, [](const auto& one) { return !one.name.starts_with("gap["); });
  by.resize(24);
  const auto back = swept(row, 18, until);
  const auto forward = impact::sensitivity(row, by, until).outcome[18];
  Index known = 0;
  for (std::size_t j = 0; j < by.size(); ++j) {
    if (std::isnan(back.slopes.gap[j])) continue;
    ++known;
    BOOST_TEST(std::abs(back.slopes.gap[j] - forward.slope[j].value()) < 1e-6);
  }
  BOOST_TEST(known >= 4);
}

BOOST_AUTO_TEST_CASE(numbers_of_a_row_may_depend_on_another) {
  const auto row = row_of(hertz, apart);
  const impact::Parameter<model::Chain> all{"all", 2, 0.02, [&](double value, model::Chain& moved) {
                                              moved = row;
                                              for (auto& law : moved.law)
                                                law = contact::Hertz(value * value / 4);
                                              for (double& mass : moved.mass) mass *= value / 2;
                                              moved.gap[2] *= value / 2;
                                            }};
  const auto forward = impact::sensitivity(row, {all}, usual);
  BOOST_TEST(std::abs(slope_by(swept(row, 4).slopes, all) - forward.outcome[4].slope[0].value()) < 1e-9);
}

// The second row vibrates without an event, so its motion is one stretch; of the third some contacts are
// damped and open.
BOOST_AUTO_TEST_CASE(a_motion_without_room_is_recorded_by_more_runs) {
  auto pressed = row_of(hertz, {-0.1, -0.2, -0.15, -0.1});
  pressed.mass.front() = pressed.mass.back() = infinity;
  pressed.velocity = {0, 0.01, 0, 0, 0};
  pressed.precompressed = true;
  const std::vector<contact::Law> damped(9, PowerLaw{1, 0.05, 1.5});
  const hybrid::Options until{.accuracy = 1e-10, .max_time = 40};
  for (const auto& [row, options] : {std::pair{row_of(hertz, apart), usual},
                                     {pressed, until},
                                     {row_of(damped, std::vector(9, 0.01)), usual}}) {
    std::vector<double> weights(row.mass.size());
    weights[row.mass.size() - 2] = 1;
    const auto all = impact::adjoint(row, weights, options);
    BOOST_TEST(all.runs == 1);
    for (const std::size_t room : {all.bytes / 3, all.bytes / 20}) {
      const auto found = impact::adjoint(
          row, weights, options, [] {}, room);
      BOOST_TEST(found.runs >= 3);
      BOOST_TEST(found.bytes < all.bytes / 2);
      BOOST_TEST(found.pieces == all.pieces);
      BOOST_TEST(found.slopes.mass == all.slopes.mass, tt::tolerance(1e-12) << tt::per_element());
      BOOST_TEST(found.slopes.velocity == all.slopes.velocity, tt::tolerance(1e-12) << tt::per_element());
      BOOST_TEST(found.slopes.stiffness == all.slopes.stiffness, tt::tolerance(1e-12) << tt::per_element());
    }
  }
}

// Runs begin at states on the way, so that not much more than twice the motion is followed.
BOOST_AUTO_TEST_CASE(a_motion_in_a_tenth_of_its_memory_is_followed_twice) {
  model::Chain row = row_of(std::vector<contact::Law>(59, contact::Hertz(1)), std::vector(59, 0.3));
  for (std::size_t i = 0; i < 60; ++i) row.velocity[i] = std::sin(40.0 * static_cast<double>(i));
  std::vector<double> weights(60);
  weights[30] = 1;
  Index steps = 0;
  const auto count = [&] { ++steps; };
  const auto all = impact::adjoint(row, weights, usual, count);
  const Index once = std::exchange(steps, 0);
  const auto found = impact::adjoint(row, weights, usual, count, all.bytes / 10);
  BOOST_TEST(found.bytes <= all.bytes / 10);
  BOOST_TEST(found.runs > 10);
  BOOST_TEST(steps > once);
  BOOST_TEST(steps < 2.5 * static_cast<double>(once));
  BOOST_TEST(found.slopes.gap == all.slopes.gap, tt::tolerance(1e-9) << tt::per_element());
}

BOOST_AUTO_TEST_CASE(what_is_not_known_is_refused) {
  auto row = row_of(hertz, touching);
  BOOST_CHECK_THROW(impact::adjoint(row, std::vector<double>(4), usual), InvalidParameter);
  BOOST_TEST(!impact::why_no_adjoint(row));
  row.law[1] = PowerLaw{1, 0.1, 1.4};
  BOOST_CHECK_THROW(swept(row, 1), InvalidParameter);
  row.law[1] = contact::Hertz(1);
  row.gravity = 1;
  row.mass[0] = infinity;
  BOOST_CHECK_THROW(swept(row, 1), InvalidParameter);
  auto stiff = usual;
  stiff.flow = flow::Kind::cvode_adams;
  BOOST_CHECK_THROW(swept(row_of(hertz, touching), 1, stiff), InvalidParameter);
}
