// Wrong slopes are seen, right and explained ones are not reported.
#define BOOST_TEST_MODULE stress_study_slopes
#include "slopes.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "differences.hpp"
#include "family.hpp"
#include "group_units.hpp"
#include "mariotte/scene/scene.hpp"
#include "measuring/timing.hpp"

using namespace mariotte;
using namespace mariotte::stress_study;

namespace {

const Scene three_balls{.model = model::Chain{.mass = {1, 2, 1.5},
                                              .law = {contact::Hertz{1}, contact::Hertz{2}},
                                              .gap = {0.1, 0.2},
                                              .velocity = {1, 0, 0}}};

/// An outcome of a number p near 1/2, whose slope there is said to be this.
SlopeSubject outcome(double (*value)(double), double said) {
  const auto at = [=](double p) {
    impact::Sensitivity slopes;
    slopes.ending = hybrid::Ending::separated;
    slopes.parameter = {{"p", p}};
    slopes.outcome = {{"velocity", 0, "m/s", value(p), {said}}};
    return slopes;
  };
  SlopeSubject subject{.speed = 1};
  subject.probes.push_back({"p", 0.5, 1, 0.01, at, at});
  subject.slopes = [=](double) { return at(0.5); };
  return subject;
}

/// An outcome eᵖ of a number p, whose slope is eᵖ times this.
SlopeSubject exponential(double factor, std::vector<impact::SlopeNote> notes = {}) {
  const auto outcome = [=](double p, double by) {
    impact::Sensitivity slopes;
    slopes.ending = hybrid::Ending::separated;
    slopes.parameter = {{"p", p}};
    slopes.outcome = {{"velocity", 0, "m/s", std::exp(p), {by * std::exp(p)}}};
    slopes.notes = notes;
    return slopes;
  };
  SlopeSubject subject{.speed = 1};
  subject.probes.push_back({"p", 0.5, 1, 0.01, [=](double p) { return outcome(p, factor); },
                            [=](double p) { return outcome(p, factor); }});
  subject.slopes = [=](double) { return outcome(0.5, factor); };
  return subject;
}

Verdict examined(const SlopeSubject& subject) {
  return examine_slopes(
      subject, 0, [](const std::string&) {}, false);
}

}  // namespace

BOOST_AUTO_TEST_CASE(differences_have_ten_digits_and_know_it) {
  const auto subject = exponential(1);
  const auto found = differences(subject.probes[0], subject.slopes(1e-10), {1}, 2);
  BOOST_TEST_REQUIRE(found.both.slope.size() == 1u);
  BOOST_TEST(std::abs(found.both.slope[0] - std::exp(0.5)) < 1e-10);
  BOOST_TEST(found.both.doubt[0] < 1e-10);
}

BOOST_AUTO_TEST_CASE(steep_outcomes_are_told_by_short_steps) {
  const auto sine = [](double p) {
    auto slopes = exponential(1).slopes(1e-10);
    slopes.outcome[0].value = std::sin(1e4 * (p - 0.5));
    return slopes;
  };
  const Probe probe{"p", 0.5, 1, 0.01, sine};
  const auto found = differences(probe, sine(0.5), {1}, 1e4);
  BOOST_TEST_REQUIRE(found.both.slope.size() == 1u);
  BOOST_TEST(std::abs(found.both.slope[0] - 1e4) < 1e-3);
}

BOOST_AUTO_TEST_CASE(differences_of_large_outcomes_know_of_rounding) {
  const auto moving = [](double p) {
    auto slopes = exponential(1).slopes(1e-10);
    slopes.outcome[0].value = 1e6 + p;
    return slopes;
  };
  const Probe probe{"p", 0.5, 1, 0.01, moving};
  const auto found = differences(probe, moving(0.5), {1}, 1);
  BOOST_TEST_REQUIRE(found.both.slope.size() == 1u);
  BOOST_TEST(std::abs(found.both.slope[0] - 1) <= found.both.doubt[0]);
  BOOST_TEST(found.both.doubt[0] > 1e-7);
}

BOOST_AUTO_TEST_CASE(right_slopes_leave_no_findings) {
  BOOST_TEST(examined(exponential(1)).findings.empty());
  const auto verdict = examined(slope_subject(three_balls, Dice(1, 1)));
  BOOST_TEST(verdict.naive);
  BOOST_TEST(verdict.findings.empty());
  BOOST_TEST(verdict.worst < 1);
}

BOOST_AUTO_TEST_CASE(a_wrong_slope_is_found_unless_a_note_says_why) {
  const auto wrong = examined(exponential(1.001));
  BOOST_TEST(!wrong.findings.empty());
  BOOST_TEST(wrong.worst > 1e5);
  const auto noted = examined(exponential(1.001, {{.text = "grazed"}}));
  BOOST_TEST(noted.findings.empty());
  BOOST_TEST(noted.refusals > 0);
}

BOOST_AUTO_TEST_CASE(a_missing_slope_is_found_unless_a_note_says_why) {
  BOOST_TEST(!examined(exponential(NAN)).findings.empty());
  BOOST_TEST(examined(exponential(NAN, {{.text = "captured"}})).findings.empty());
}

BOOST_AUTO_TEST_CASE(a_note_about_other_slopes_or_smaller_errors_excuses_nothing) {
  const auto is_excused = [](double factor, const impact::SlopeNote& note) {
    return examined(exponential(factor, {note})).findings.empty();
  };
  for (const double factor : {1.001, static_cast<double>(NAN)}) {
    BOOST_TEST(is_excused(factor, {.outcomes = {"time", "velocity[0]"}}));
    BOOST_TEST(!is_excused(factor, {.outcomes = {"time"}}));
    BOOST_TEST(is_excused(factor, {.parameters = {"p"}}));
    BOOST_TEST(!is_excused(factor, {.parameters = {"q"}}));
    BOOST_TEST(!is_excused(factor, {.error = 0}));
  }
  BOOST_TEST(is_excused(1.001, {.error = 1e-3}));
  BOOST_TEST(!is_excused(1.001, {.error = 1e-5}));
}

BOOST_AUTO_TEST_CASE(numbers_that_move_one_way_only_are_left_out) {
  auto touching = three_balls;
  auto& chain = std::get<model::Chain>(touching.model);
  chain.gap = {0, 0};
  for (std::uint64_t n = 0; n < 40; ++n)
    for (const auto& one : slope_subject(touching, Dice(2, n)).probes) {
      BOOST_TEST(!one.name.starts_with("gap"));
      BOOST_TEST(one.name != "velocity[1]");
      BOOST_TEST(one.name != "velocity[2]");
    }
}

// Of two balls that touch, the right one at rest beside a plane: what may move both ways, and how far.
BOOST_AUTO_TEST_CASE(bodies_that_touch_are_moved_nowhere) {
  const auto scene = scene::parse(
      "[bodies]\ndimension = 2\nlaw = \"hertz\"\nstiffness = 1e9\n"
      "[[bodies.plane]]\npoint = [0.04, 0]\nnormal = [-1, 0]\n"
      "[[bodies.contact]]\nbetween = [1, 2]\n[[bodies.contact]]\nbetween = [2, \"plane 1\"]\n"
      "[[bodies.body]]\nshape = \"ball\"\nradius = 0.01\nmass = 1\nposition = [-0.02, 0]\nvelocity = [1, 0]\n"
      "[[bodies.body]]\nshape = \"ball\"\nradius = 0.01\nmass = 1\nposition = [0.03, 0]\n",
      "test");
  const auto& bodies = std::get<model::Bodies>(scene.model);
  std::vector<std::string> moved;
  for (const auto& one : impact::parameters(bodies))
    if (const auto unit = unit_of(bodies, one, 1)) {
      moved.push_back(one.name);
      if (one.name == "body[0].position[0]") BOOST_TEST(longest_step(bodies, one, *unit) <= 0.1 * 0.03);
    }
  const auto has = [&](const std::string& name) {
    return std::find(moved.begin(), moved.end(), name) != moved.end();
  };
  for (const auto* name : {"body[0].position[0]", "body[0].velocity[0]", "body[1].mass"})
    BOOST_TEST(has(name), name);
  for (const auto* name : {"body[1].position[0]", "body[1].velocity[0]", "body[1].radius"})
    BOOST_TEST(!has(name), name);
}

// As where two events change places: each side has its own slope.
BOOST_AUTO_TEST_CASE(next_to_a_kink_slopes_are_those_of_a_side) {
  const auto bent = [](double p) { return (p > 0.5 - 1e-9 ? 2 : 1) * (p - 0.5 + 1e-9); };
  for (const double right : {1.0, 2.0}) BOOST_TEST(examined(outcome(bent, right)).findings.empty());
  for (const double wrong : {0.9, 1.5, 2.001}) BOOST_TEST(!examined(outcome(bent, wrong)).findings.empty());
  BOOST_TEST(examined(outcome(bent, 2)).naive);
}

// Steps of this number are divided by what they are after rounding.
BOOST_AUTO_TEST_CASE(points_are_numbers_that_exist) {
  const auto fast = [](double p) { return p - 0x1p40; };
  auto probe = outcome(fast, 1).probes[0];
  probe.value += 0x1p40;
  const auto found = differences(probe, outcome(fast, 1).slopes(1e-10), {1}, 1);
  BOOST_TEST_REQUIRE(found.both.slope.size() == 1u);
  BOOST_TEST(std::abs(found.both.slope[0] - 1) < 1e-12);
}

// Noise of 10⁻⁹ that is the same for steps of two lengths.
BOOST_AUTO_TEST_CASE(two_steps_that_agree_by_chance_do_not_count) {
  const auto noisy = [](double p) { return p + 1e-9 * std::sin(1e7 * (p - 0.5) + 1); };
  const auto subject = outcome(noisy, 1);
  const auto found = differences(subject.probes[0], subject.slopes(1e-10), {1}, 1);
  BOOST_TEST(std::abs(found.both.slope[0] - 1) <= 10 * found.both.doubt[0]);
  BOOST_TEST(examined(subject).findings.empty());
}

BOOST_AUTO_TEST_CASE(bodies_with_friction_have_power_laws_and_are_moved_where_they_may_be) {
  const auto list = families({"friction-slopes"});
  for (std::uint64_t n = 0; n < 2 * list.size(); ++n) {
    const auto scene = scene_of(list, 3, n);
    const auto& bodies = std::get<Group>(scene.model).bodies;
    for (const auto& one : bodies.contact) BOOST_TEST(contact::power_law(one.law));
    const auto subject = slope_subject(scene, Dice(4, n));
    BOOST_TEST(!subject.probes.empty());
    for (const auto& probe : subject.probes)
      for (const double steps : {-4, 4})
        BOOST_CHECK_NO_THROW(probe.outcomes(probe.value + steps * probe.step));
  }
}

BOOST_AUTO_TEST_CASE(impulses_of_a_hardly_touching_pair_are_weighed_by_what_stops_it) {
  const Scene parting{.model = model::Chain{.mass = {1, 3},
                                            .law = {contact::Hertz{1e-3}},
                                            .gap = {-1e-3},
                                            .velocity = {-0.1, 0.2},
                                            .precompressed = true}};
  const auto subject = slope_subject(parting, Dice(1, 1));
  BOOST_TEST(std::abs(subject.impulse / (0.75 * subject.speed) - 1) < 1e-12);
  const auto slopes = subject.slopes(1e-10);
  for (std::size_t i = 0; i < slopes.outcome.size(); ++i)
    if (slopes.outcome[i].name == "impulse") BOOST_TEST(outcome_sizes(slopes, subject)[i] == subject.impulse);
}

BOOST_AUTO_TEST_CASE(brisk_campaigns_leave_out_slopes_that_take_long) {
  auto slow = exponential(1);
  slow.slopes = [quick = slow.slopes](double accuracy) {
    const double start = measuring::cpu_seconds();
    while (measuring::cpu_seconds() - start < 0.02) {
    }
    return quick(accuracy);
  };
  const auto silent = [](const std::string&) {};
  BOOST_TEST(examine_slopes(slow, 0, silent, true).left_out);
  BOOST_TEST(!examine_slopes(slow, 0, silent, false).left_out);
}
