// What a flow that follows any smooth field must do, on fields of a line; what every flow must do is asked in
// test_conformance.cpp.
#define BOOST_TEST_MODULE flows of any field
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "mariotte/flow/choose.hpp"
#include "support/toy_problems.hpp"

using namespace mariotte;
using namespace mariotte::test;
using flow::Crossing;
using flow::Outcome;
using std::numbers::pi;

namespace {

const flow::Kind flows[] = {flow::Kind::cvode_adams, flow::Kind::cvode_bdf_dense, flow::Kind::cvode_bdf_band,
                            flow::Kind::cvode_bdf_klu};

struct Result {
  flow::Arrival arrival;
  std::vector<double> x;
  std::vector<Index> fired;
};

Result follow(flow::Kind kind, flow::Problem& problem, std::vector<double> x, double accuracy = 1e-9,
              double limit = 100, flow::StepObserver* observer = nullptr) {
  flow::Flows made;
  Result result{{}, x, {}};
  result.arrival =
      made.get(kind, problem).follow(problem, result.x, {limit, accuracy, observer}, result.fired);
  return result;
}

struct Recorder : flow::StepObserver {
  void observe(const flow::Step& step) override {
    starts.push_back(step.start);
    ends.push_back(step.end);
    std::vector<double> x(step.before.size());
    for (const double part : {0.25, 0.5, 0.75}) {
      const double time = step.start + part * (step.end - step.start);
      step.at(time, x);
      worst = std::max(worst, std::abs(x[0] - std::sin(time)));
    }
  }
  std::vector<double> starts, ends;
  double worst = 0;
};

}  // namespace

namespace mariotte::flow {
inline std::ostream& operator<<(std::ostream& out, Kind kind) {
  return out << name(kind);
}
}  // namespace mariotte::flow

BOOST_DATA_TEST_CASE(known_event_times_are_met, boost::unit_test::data::make(flows), kind) {
  for (const double level : {0.1, 0.5, 0.9, 0.999}) {
    auto rising = oscillator({level}, {Crossing::rising}), falling = oscillator({level}, {Crossing::falling});
    const auto up = follow(kind, rising, {0, 1}), down = follow(kind, falling, {0, 1});
    BOOST_TEST((up.arrival.outcome == Outcome::guard));
    // Near the top the crossing is shallow: an error of x moves the time by error/slope.
    const double slope = std::sqrt(1 - level * level);
    BOOST_TEST(std::abs(up.arrival.duration - std::asin(level)) < 1e-9 / slope);
    BOOST_TEST(std::abs(down.arrival.duration - (pi - std::asin(level))) < 1e-9 / slope);
    BOOST_TEST(std::abs(up.x[0] - level) < 1e-13);
  }
}

BOOST_DATA_TEST_CASE(guards_that_fire_together_are_one_event, boost::unit_test::data::make(flows), kind) {
  auto problem = oscillator({0.5, 0.5, 0.7}, {Crossing::rising, Crossing::rising, Crossing::rising});
  auto result = follow(kind, problem, {0, 1});
  std::sort(result.fired.begin(), result.fired.end());
  BOOST_TEST(result.fired == (std::vector<Index>{0, 1}), boost::test_tools::per_element());
}

BOOST_DATA_TEST_CASE(a_guard_that_is_zero_at_the_start_does_not_fire_there,
                     boost::unit_test::data::make(flows), kind) {
  auto again = oscillator({0.0}, {Crossing::rising});
  BOOST_TEST(std::abs(follow(kind, again, {0, 1}).arrival.duration - 2 * pi) < 1e-8);
  auto back = oscillator({0.0}, {Crossing::falling});
  BOOST_TEST(std::abs(follow(kind, back, {0, 1}).arrival.duration - pi) < 1e-8);
}

BOOST_DATA_TEST_CASE(a_crossing_the_other_way_does_not_fire, boost::unit_test::data::make(flows), kind) {
  auto problem = oscillator({0.5}, {Crossing::falling});
  const auto result = follow(kind, problem, {0, 1});
  BOOST_TEST(std::abs(result.arrival.duration - 5 * pi / 6) < 1e-8);
}

// Nothing is searched for: it costs hardly more than a guard on its side.
BOOST_DATA_TEST_CASE(a_guard_that_stays_beyond_zero_is_cheap, boost::unit_test::data::make(flows), kind) {
  const auto asked = [&](Crossing crossing) {
    long guards = 0;
    Toy problem(
        2, [](ConstState x, State dx) { dx[0] = x[1], dx[1] = -x[0]; }, 1,
        [&](ConstState x, State g) { g[0] = x[0] - 2, ++guards; }, {crossing});
    BOOST_TEST((follow(kind, problem, {0, 1}).arrival.outcome == Outcome::limit));
    return guards;
  };
  BOOST_TEST(asked(Crossing::falling) < 2 * asked(Crossing::rising));
}

BOOST_DATA_TEST_CASE(a_masked_guard_never_fires, boost::unit_test::data::make(flows), kind) {
  // A masked guard keeps one sign by contract.
  Toy problem(
      2, [](ConstState x, State dx) { dx[0] = x[1], dx[1] = -x[0]; }, 2,
      [](ConstState x, State g) { g[0] = 1, g[1] = x[0] - 0.5; }, {Crossing::none, Crossing::rising});
  const auto result = follow(kind, problem, {0, 1});
  BOOST_TEST(result.fired == std::vector<Index>{1}, boost::test_tools::per_element());
}

BOOST_DATA_TEST_CASE(bodies_at_rest_stay_at_rest_to_the_last_bit, boost::unit_test::data::make(flows), kind) {
  // Two resting bodies beside an oscillating one; their touching gap is exactly zero and must stay so.
  Toy problem(
      4, [](ConstState x, State dx) { dx[0] = x[1], dx[1] = -x[0], dx[2] = 0 * x[3], dx[3] = 0; }, 2,
      [](ConstState x, State g) { g[0] = x[2], g[1] = x[0] - 0.5; }, {Crossing::falling, Crossing::falling});
  const auto result = follow(kind, problem, {0, 1, 0, 0});
  BOOST_TEST(result.fired == std::vector<Index>{1}, boost::test_tools::per_element());
  BOOST_TEST(result.x[2] == 0);
  BOOST_TEST(result.x[3] == 0);
}

BOOST_DATA_TEST_CASE(the_time_limit_is_met_exactly, boost::unit_test::data::make(flows), kind) {
  auto problem = oscillator({2.0}, {Crossing::rising});
  const auto result = follow(kind, problem, {0, 1}, 1e-9, 1.25);
  BOOST_TEST((result.arrival.outcome == Outcome::limit));
  BOOST_TEST(result.arrival.duration == 1.25);
  BOOST_TEST(std::abs(result.x[0] - std::sin(1.25)) < 1e-9);
}

BOOST_DATA_TEST_CASE(steps_join_and_are_dense, boost::unit_test::data::make(flows), kind) {
  auto problem = oscillator({0.5}, {Crossing::falling});
  Recorder recorder;
  const auto result = follow(kind, problem, {0, 1}, 1e-9, 100, &recorder);
  BOOST_TEST(recorder.starts.front() == 0);
  BOOST_TEST(recorder.ends.back() == result.arrival.duration);
  for (std::size_t i = 1; i < recorder.starts.size(); ++i)
    BOOST_TEST(recorder.starts[i] == recorder.ends[i - 1]);
  BOOST_TEST(recorder.worst < 1e-9);
}

BOOST_DATA_TEST_CASE(a_field_that_is_not_finite_is_a_named_failure, boost::unit_test::data::make(flows),
                     kind) {
  Toy problem(
      1, [](ConstState x, State dx) { dx[0] = x[0] > 0.5 ? std::nan("") : 1.0; }, 1,
      [](ConstState x, State g) { g[0] = x[0] - 1; }, {Crossing::rising});
  const auto result = follow(kind, problem, {0});
  BOOST_TEST((result.arrival.outcome == Outcome::failed));
  BOOST_TEST_CONTEXT(result.arrival.message)
  BOOST_TEST(result.arrival.message.find("x0") != std::string::npos);
  BOOST_TEST(result.x[0] <= 0.5 + 1e-6);
}

BOOST_DATA_TEST_CASE(a_guard_that_is_not_finite_is_a_named_failure, boost::unit_test::data::make(flows),
                     kind) {
  Toy problem(
      1, [](ConstState, State dx) { dx[0] = 1; }, 1,
      [](ConstState x, State g) { g[0] = x[0] > 0.5 ? std::nan("") : -1.0; }, {Crossing::rising});
  BOOST_TEST((follow(kind, problem, {0}).arrival.outcome == Outcome::failed));
}

BOOST_DATA_TEST_CASE(the_error_falls_with_the_accuracy_asked, boost::unit_test::data::make(flows), kind) {
  // Asked is got, and eight decades of accuracy give at least six of error.
  double first = 0, last = 0;
  for (const double accuracy : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    auto problem = oscillator({2.0}, {Crossing::rising});
    const auto result = follow(kind, problem, {0, 1}, accuracy, 3.0);
    last = std::max(std::abs(result.x[0] - std::sin(3.0)), std::abs(result.x[1] - std::cos(3.0)));
    if (accuracy == 1e-2) first = last;
    BOOST_TEST(last <= accuracy);
  }
  BOOST_TEST(last < 1e-6 * first);
}

BOOST_DATA_TEST_CASE(memory_kept_from_one_phase_does_not_change_the_next, boost::unit_test::data::make(flows),
                     kind) {
  auto problem = oscillator({0.5}, {Crossing::falling});
  flow::Flows kept;
  std::vector<double> first = {0, 1}, second = {0, 1};
  std::vector<Index> fired;
  kept.get(kind, problem).follow(problem, first, {100, 1e-9, nullptr}, fired);
  kept.get(kind, problem).follow(problem, second, {100, 1e-9, nullptr}, fired);
  BOOST_TEST(first == second, boost::test_tools::per_element());
}

BOOST_DATA_TEST_CASE(a_graze_shorter_than_a_step_is_not_missed, boost::unit_test::data::make(flows), kind) {
  // x = sin t passes 1 − depth and comes back within 2√(2 depth).
  for (const double depth : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    auto up = oscillator({1 - depth}, {Crossing::rising}),
         down = oscillator({depth - 1}, {Crossing::falling});
    const double early = std::acos(1 - depth);
    BOOST_TEST(std::abs(follow(kind, up, {0, 1}).arrival.duration - (pi / 2 - early)) <
               1e-8 / std::sqrt(depth));
    BOOST_TEST(std::abs(follow(kind, down, {0, 1}).arrival.duration - (3 * pi / 2 - early)) <
               1e-8 / std::sqrt(depth));
  }
}

BOOST_DATA_TEST_CASE(a_near_miss_does_not_fire, boost::unit_test::data::make(flows), kind) {
  for (const double distance : {1e-2, 1e-4, 1e-6}) {
    auto problem = oscillator({1 + distance}, {Crossing::rising});
    BOOST_TEST((follow(kind, problem, {0, 1}, 1e-9, 7).arrival.outcome == Outcome::limit));
  }
}
