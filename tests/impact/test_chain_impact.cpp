#define BOOST_TEST_MODULE impact of a chain
#include <boost/test/unit_test.hpp>

#include "mariotte/core/error.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;
using hybrid::Ending;

namespace {

const contact::Law hertz = contact::Hertz{1};

/// A ball that bounces on a wall under gravity, losing energy each time.
model::Chain bouncing() {
  return {.mass = {infinity, 1},
          .law = {contact::Viscoelastic{.stiffness = 1e6, .damping = 100, .exponent = 1}},
          .gap = {1},
          .velocity = {0, 0},
          .gravity = 9.81};
}

}  // namespace

BOOST_AUTO_TEST_CASE(balls_that_part_from_the_start_are_over_at_once) {
  const auto impact = impact::simulate(equal_masses({hertz, hertz}, {-1, 0, 1}));
  BOOST_TEST((impact.ending == Ending::separated));
  BOOST_TEST(impact.time == 0);
  BOOST_TEST(impact.events.empty());
  BOOST_TEST(impact.flows.empty());
}

BOOST_AUTO_TEST_CASE(touching_balls_at_rest_make_no_ghost_events) {
  const auto impact = impact::simulate(equal_chain(21));
  BOOST_TEST(impact.events.size() == 21u);  // one onset of all, and every contact opens once
  BOOST_TEST(impact.events.front().close.size() == 20u);
}

BOOST_AUTO_TEST_CASE(two_contacts_that_open_at_one_instant_are_one_event) {
  for (const auto& law : {contact::Law(contact::Linear{1}), hertz}) {
    const auto impact = impact::simulate(equal_masses({law, law}, {1, 0, -1}));
    BOOST_TEST(impact.events.size() == 2u);
    BOOST_TEST(impact.events.back().open == (std::vector<Index>{0, 1}), boost::test_tools::per_element());
    BOOST_TEST(difference(impact.velocity, {-1, 0, 1}) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(ratios_are_undefined_where_no_impulse_was_exchanged) {
  auto chain = equal_masses({hertz, hertz, hertz}, {1, 0, 2, 3});
  const auto impact = impact::simulate(chain);
  BOOST_TEST(!impact.icr[0].has_value());  // p₁/0
  BOOST_TEST(!impact.icr[1].has_value());  // 0/0
  BOOST_TEST(impact.impulse_direction == (Numbers{1, 0, 0}), boost::test_tools::per_element());
  BOOST_TEST(impact.contacts[2].periods.empty());
}

BOOST_AUTO_TEST_CASE(the_ratio_of_an_untouched_first_contact_is_zero) {
  const auto impact = impact::simulate(equal_masses({hertz, hertz}, {-1, 1, 0}));
  BOOST_TEST(impact.icr[0].value() == 0);
}

BOOST_AUTO_TEST_CASE(peaks_of_a_pair_are_those_of_hertz) {
  const auto impact = impact::simulate(equal_masses({hertz}, {1, 0}));
  const double indentation = std::pow(1.25 * 0.5, 0.4);  // (5 m* v²/4k)^{2/5}
  BOOST_TEST(impact.contacts[0].peak_indentation == indentation, boost::test_tools::tolerance(1e-11));
  BOOST_TEST(impact.contacts[0].peak_force == std::pow(indentation, 1.5),
             boost::test_tools::tolerance(1e-11));
  BOOST_TEST(impact.time == 2.94328 * indentation, boost::test_tools::tolerance(2e-6));
}

BOOST_AUTO_TEST_CASE(the_peak_force_of_a_damped_linear_contact_may_be_its_first) {
  const contact::Viscoelastic law{.stiffness = 1, .damping = 5, .exponent = 1};
  const auto impact = impact::simulate(equal_masses({law}, {1, 0}));
  BOOST_TEST(impact.contacts[0].peak_force == 5, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(energy_ratios_name_their_frame) {
  const contact::Viscoelastic law{.stiffness = 1, .damping = 1, .exponent = 1};
  const auto rest = impact::simulate(equal_masses({law}, {1, 0}));
  const auto centre = impact::simulate(equal_masses({law}, {0.5, -0.5}));
  BOOST_TEST(*rest.energy.ratio_lab > *rest.energy.ratio_centre);
  BOOST_TEST(std::abs(*rest.energy.ratio_centre - *centre.energy.ratio_centre) < 1e-10);
  BOOST_TEST(std::abs(*centre.energy.ratio_lab - *centre.energy.ratio_centre) < 1e-10);
}

BOOST_AUTO_TEST_CASE(a_wall_keeps_its_velocity_and_its_impulse_is_known) {
  const auto impact =
      impact::simulate({.mass = {1, infinity}, .law = {hertz}, .gap = {0.3}, .velocity = {2, 0.5}});
  BOOST_TEST(impact.velocity[1] == 0.5);
  BOOST_TEST(std::abs(impact.velocity[0] + 1) < 1e-10);
  BOOST_TEST(std::abs(impact.contacts[0].impulse - 3) < 1e-10);
  BOOST_TEST(std::abs(impact.energy.work + 1.5) < 1e-10);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-10);
}

// The momentum of a ball ten million times as heavy has no digits for what it gives.
BOOST_AUTO_TEST_CASE(impulses_of_balls_that_strike_a_heavy_one_have_all_their_digits) {
  const double heavy = 2022.58, light = 2.6e-4, reduced = heavy * light / (heavy + light), approach = 0.5;
  for (const bool heavy_first : {true, false}) {
    const model::Chain pair{.mass = {heavy_first ? heavy : light, heavy_first ? light : heavy},
                            .law = {contact::Hertz{450}},
                            .gap = {0},
                            .velocity = {heavy_first ? 0.0625 : 0.5625, heavy_first ? -0.4375 : 0.0625}};
    const auto impact = impact::simulate(pair, {.accuracy = 1e-14});
    BOOST_TEST(std::abs(impact.contacts[0].impulse / (2 * reduced * approach) - 1) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(between_two_walls_every_impulse_is_known) {
  const model::Chain chain{.mass = {infinity, 1, 2, 1, infinity},
                           .law = {hertz, hertz, hertz, hertz},
                           .gap = {0.1, 0, 0, 0.1},
                           .velocity = {0, 1, 0, -0.3, 0}};
  const auto impact = impact::simulate(chain, {.max_time = 50});
  BOOST_TEST((impact.ending == Ending::time_limit));
  BOOST_TEST(impact.time == 50);
  BOOST_TEST(std::abs(impact.momentum.residual) < 1e-10);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-8);
  for (std::size_t i = 1; i <= 3; ++i)
    BOOST_TEST(std::abs(impact.contacts[i - 1].impulse - impact.contacts[i].impulse -
                        chain.mass[i] * (impact.velocity[i] - chain.velocity[i])) < 1e-9);
}

BOOST_AUTO_TEST_CASE(precompressed_balls_fly_apart_with_the_stored_energy) {
  const auto impact = impact::simulate(
      {.mass = {1, 1}, .law = {hertz}, .gap = {-0.5}, .velocity = {0, 0}, .precompressed = true});
  const double stored = 0.4 * std::pow(0.5, 2.5);
  BOOST_TEST(impact.energy.initial == stored, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(impact.velocity[1] - std::sqrt(stored)) < 1e-10);
}

BOOST_AUTO_TEST_CASE(a_dropped_ball_ends_after_its_first_bounce_or_goes_on_to_the_time_asked) {
  const auto once = impact::simulate(bouncing());
  BOOST_TEST((once.ending == Ending::separated));
  BOOST_TEST(once.contacts[0].periods.size() == 1u);
  BOOST_TEST(std::abs(once.contacts[0].periods[0].start - std::sqrt(2 / 9.81)) < 1e-10);
  const auto longer = impact::simulate(bouncing(), {.max_time = 2});
  BOOST_TEST((longer.ending == Ending::time_limit));
  BOOST_TEST(longer.contacts[0].periods.size() > 1u);
  BOOST_TEST(std::abs(longer.energy.residual) < 1e-8);
}

// Two balls that touch fall on a wall from 1 m: the lower meets it at √(2 g h), and the upper, which has been
// in touch from the start, meets the lower at no speed.
BOOST_AUTO_TEST_CASE(contacts_know_how_fast_their_balls_met_and_parted) {
  auto chain = bouncing();
  const auto impact = impact::simulate(chain);
  const auto& speeds = impact.contacts[0].meeting;
  const double fall = std::sqrt(2 * 9.81);
  BOOST_TEST(std::abs(*speeds.approach - fall) < 1e-9);
  BOOST_TEST(*speeds.separation < *speeds.approach);
  BOOST_TEST(std::abs(*speeds.separation -
                      (impact.velocity[1] + 9.81 * (impact.time - *impact.contacts[0].periods[0].end))) <
             1e-9);
  chain.mass.push_back(1);
  chain.velocity.push_back(0);
  chain.gap.push_back(0);
  chain.law.push_back(hertz);
  const auto two = impact::simulate(chain, {.max_time = 1});
  BOOST_TEST(std::abs(*two.contacts[0].meeting.approach - fall) < 1e-9);
  BOOST_TEST(std::abs(two.contacts[1].meeting.approach.value_or(0)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(contacts_that_never_meet_or_start_indented_have_no_speed_of_approach) {
  const auto apart = impact::simulate(equal_masses({hertz, hertz}, {1, 0, 9}));
  BOOST_TEST(*apart.contacts[0].meeting.approach == 1);
  BOOST_TEST(!apart.contacts[1].meeting.approach);
  BOOST_TEST(!apart.contacts[1].meeting.separation);
  auto pressed = equal_masses({hertz}, {0, 0});
  pressed.gap = {-0.1};
  pressed.precompressed = true;
  const auto impact = impact::simulate(pressed);
  BOOST_TEST(!impact.contacts[0].meeting.approach);
  BOOST_TEST(std::abs(*impact.contacts[0].meeting.separation - (impact.velocity[1] - impact.velocity[0])) <
             1e-10);
}

BOOST_AUTO_TEST_CASE(islands_know_the_same_speeds_as_one_system) {
  auto chain = equal_chain(60);
  for (std::size_t j = 0; j < chain.gap.size(); ++j) chain.gap[j] = j % 2 == 0 ? 0.1 : 0.3;
  const auto islands = impact::simulate(chain), whole = impact::simulate(chain, {.flow = flow::Kind::taylor});
  for (std::size_t j = 0; j < chain.gap.size(); ++j) {
    BOOST_REQUIRE(islands.contacts[j].meeting.approach);
    BOOST_TEST(std::abs(*islands.contacts[j].meeting.approach - *whole.contacts[j].meeting.approach) < 1e-8,
               j);
    BOOST_TEST(
        std::abs(*islands.contacts[j].meeting.separation - *whole.contacts[j].meeting.separation) < 1e-8, j);
  }
  BOOST_TEST(*islands.contacts[0].meeting.approach == 1, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(limits_keep_what_was_computed) {
  const auto impact = impact::simulate(equal_chain(5), {.max_events = 2});
  BOOST_TEST((impact.ending == Ending::event_limit));
  BOOST_TEST(impact.events.size() == 2u);
  BOOST_TEST(std::abs(impact.momentum.residual) < 1e-13);
  BOOST_TEST(std::abs(impact.energy.residual) < 1e-9);
  BOOST_TEST(!impact.contacts[3].periods[0].end.has_value());
}

BOOST_AUTO_TEST_CASE(a_bouncing_ball_that_comes_to_rest_ends_at_a_limit) {
  const auto impact = impact::simulate(bouncing(), {.max_time = 1e9, .max_events = 40});
  BOOST_TEST((impact.ending == Ending::event_limit));
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_rejected) {
  const auto chain = equal_chain(3);
  const auto rejects = [](model::Chain bad, hybrid::Options options = {}) {
    BOOST_CHECK_THROW(impact::simulate(bad, options), InvalidParameter);
  };
  for (const double accuracy : {0.0, -1.0, 1.0, std::nan("")}) rejects(chain, {.accuracy = accuracy});
  rejects(chain, {.max_time = 0});
  rejects(chain, {.max_events = 0});
  rejects(chain, {.flow = flow::Kind::ballistic});
  auto bad = chain;
  bad.mass[1] = std::nan("");
  rejects(bad);
  bad = chain;
  bad.law[0] = contact::Hertz{-1};
  rejects(bad);
  bad = chain;
  bad.gap[0] = -0.1;
  rejects(bad);
  bad = chain;
  bad.velocity.pop_back();
  rejects(bad);
}

BOOST_AUTO_TEST_CASE(a_trace_begins_at_the_start_and_ends_at_the_end) {
  const auto impact = impact::simulate(equal_chain(40), {}, {.trace = true});
  const auto& trace = impact.trace;
  BOOST_TEST(trace.time.size() > 500u);
  BOOST_TEST(trace.time.size() <= 4097u);
  BOOST_TEST(trace.time.front() == 0);
  BOOST_TEST(trace.time.back() == impact.time, boost::test_tools::tolerance(1e-15));
  for (const auto* rows : {&trace.velocity, &trace.gap, &trace.force})
    BOOST_TEST(rows->size() == trace.time.size());
  BOOST_TEST(trace.velocity.front().size() == 40u);
  BOOST_TEST(difference(trace.velocity.back(), impact.velocity) < 1e-15);
  BOOST_TEST(std::is_sorted(trace.time.begin(), trace.time.end()));
}

BOOST_AUTO_TEST_CASE(a_long_rest_takes_no_rows_from_the_impacts_before_it) {
  const model::Chain ball{.mass = {infinity, 1},
                          .law = {contact::Viscoelastic{.stiffness = 1e9, .damping = 1e5, .exponent = 1.5}},
                          .gap = {0.1},
                          .velocity = {0, 0},
                          .gravity = 9.81};
  const auto impact = impact::simulate(ball, {.max_time = 10}, {.trace = true});
  double strongest = 0;
  for (const auto& force : impact.trace.force) strongest = std::max(strongest, force[0]);
  BOOST_TEST(impact.contacts[0].periods.front().start < 0.2);
  BOOST_TEST(strongest == impact.contacts[0].peak_force, boost::test_tools::tolerance(0.01));
  BOOST_TEST(impact.trace.time.size() <= 4097u);
}

BOOST_AUTO_TEST_CASE(nothing_is_traced_unless_asked_for) {
  BOOST_TEST(impact::simulate(equal_chain(3)).trace.time.empty());
}
