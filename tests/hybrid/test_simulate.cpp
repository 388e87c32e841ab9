// The event loop on systems that know nothing of mechanics: every way a run can end that is the loop's to
// decide, and every way a flow can stop. `unsure` is not among them: the gate of a finished run gives it.
#define BOOST_TEST_MODULE hybrid_simulate
#include <boost/test/unit_test.hpp>
#include <limits>

#include "mariotte/core/error.hpp"
#include "mariotte/hybrid/simulate.hpp"
#include "support/toy_system.hpp"

using namespace mariotte;
using namespace mariotte::test;
using flow::Crossing;
using hybrid::Ending;

namespace {

using Run = hybrid::Trajectory<ToySystem::Change>;
using Changes = std::vector<ToySystem::Change>;

Run run(ToySystem system, std::vector<double> x, const hybrid::Options& options = {},
        hybrid::PhaseObserver* observer = nullptr) {
  hybrid::Workspace<ToySystem> workspace;
  return hybrid::simulate(system, x, options, workspace, observer);
}

template <class... Phases>
std::vector<std::shared_ptr<flow::Problem>> list(const Phases&... phases) {
  return {std::make_shared<Phases>(phases)...};
}

Changes changes(const Run& run) {
  Changes all;
  for (const auto& one : run.changes) all.push_back(one.change);
  return all;
}

Index phases(const Run& run, flow::Kind kind) {
  return run.flows[static_cast<std::size_t>(kind)].phases;
}

/// A point that runs at speed 1 from wall to wall, 0 and `width`.
ToySystem corridor(double width) {
  return {.phases = list(Ramp(1, {width}, {Crossing::rising}), Ramp(-1, {0}, {Crossing::falling})),
          .next = [](Index mode, const auto&) { return 1 - mode; }};
}

/// One mode, over as soon as a guard has fired.
template <class Problem>
ToySystem single(const Problem& problem) {
  return {.phases = list(problem), .next = following, .last = 1};
}

/// x = sin t from 0 until x = 1/2, left to BDF; beyond x = 1/4 its Jacobian is not a number.
struct WithoutJacobian : Toy {
  WithoutJacobian() : Toy(oscillator({0.5}, {Crossing::rising})) { damping = 10; }
  void jacobian(ConstState x, State values) const override {
    Toy::jacobian(x, values);
    if (x[0] > 0.25) values[0] = std::numeric_limits<double>::quiet_NaN();
  }
};

/// A ball that rests on a dashpot is pressed by a force 1: δ̈ + c δ̇ + δ = 1, without end. State: velocities
/// of floor and ball, gap.
struct Dashpot : Toy {
  static constexpr double damping_constant = 1e4;
  flow::SerialPhase row;

  Dashpot()
      : Toy(
            3, [](ConstState x, State dx) { dx[0] = 0, dx[1] = load(x) - 1, dx[2] = x[1]; }, 2,
            [](ConstState x, State g) { g[0] = -1, g[1] = load(x); }, {Crossing::none, Crossing::falling}) {
    damping = damping_constant;
    row.body = {{.velocity = 0, .inverse_mass = 0, .acceleration = 0},
                {.velocity = 1, .inverse_mass = 1, .acceleration = -1}};
    row.contact = {{.gap = 2,
                    .work = -1,
                    .impulse = -1,
                    .guard = 0,
                    .load_guard = 1,
                    .stiffness = 1,
                    .damping = damping_constant,
                    .exponent = 1,
                    .length = 1,
                    .noise_depth = 0,
                    .role = flow::Role::closed}};
  }
  static double load(ConstState x) { return -x[2] - damping_constant * x[1]; }
  double time_scale() const override { return 1 / damping_constant; }
  const flow::SerialPhase* serial() const override { return &row; }
};

/// Where phases begin, and whether their steps follow each other on the absolute clock.
struct Recorder : hybrid::PhaseObserver {
  void begin_phase(double time, ConstState x) override {
    begins.push_back(time);
    states.emplace_back(x.begin(), x.end());
    end = 0;
  }
  void observe(const flow::Step& step) override {
    joined = joined && step.start == end;
    end = step.end;
  }
  std::vector<double> begins;
  std::vector<std::vector<double>> states;
  double end = 0;
  bool joined = true;
};

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_over_at_the_start_is_followed_by_no_flow) {
  auto system = corridor(1);
  system.last = 0;
  const auto found = run(system, {0.25});
  BOOST_TEST((found.ending == Ending::separated));
  BOOST_TEST(found.time == 0);
  BOOST_TEST(found.state == std::vector<double>{0.25}, boost::test_tools::per_element());
  BOOST_TEST(found.events == 0);
  for (const auto kind : flow::kinds) BOOST_TEST(phases(found, kind) == 0);
}

BOOST_AUTO_TEST_CASE(a_guard_leads_to_the_next_mode_and_x_is_continuous) {
  const auto found = run(corridor(1), {0.25}, {.max_events = 3});
  BOOST_TEST((found.ending == Ending::event_limit));
  BOOST_TEST(found.events == 3);
  BOOST_TEST((changes(found) == Changes{{0, 1}, {0, 0}, {0, 1}}));
  for (std::size_t k = 0; k < 3; ++k) BOOST_TEST(found.changes[k].time == 0.75 + static_cast<double>(k));
  BOOST_TEST(found.time == 2.75);
  BOOST_TEST(found.state[0] == 1);
  BOOST_TEST(phases(found, flow::Kind::ballistic) == 3);
}

BOOST_AUTO_TEST_CASE(time_is_as_good_after_many_events_as_after_one) {
  // A plain sum of so many tenths would be off by 1e-8.
  constexpr Index events = 100000;
  const auto found = run(corridor(0.1), {0}, {.max_events = events});
  double worst = 0;
  for (Index k = 0; k < events; ++k) {
    const long double exact = static_cast<long double>(k + 1) * 0.1;
    worst = std::max(worst, static_cast<double>(std::abs(found.changes[k].time / exact - 1)));
  }
  BOOST_TEST(worst <= epsilon);
}

BOOST_AUTO_TEST_CASE(guards_that_fire_together_are_one_event) {
  ToySystem system{
      .phases = list(Ramp(1, {1, 2, 1}, std::vector(3, Crossing::rising))), .next = following, .last = 1};
  const auto found = run(system, {0});
  BOOST_TEST((found.ending == Ending::separated));
  BOOST_TEST(found.events == 1);
  BOOST_TEST((changes(found) == Changes{{0, 1}, {2, 1}}));
  BOOST_TEST(found.changes[0].time == 1);
  BOOST_TEST(found.changes[1].time == 1);
}

BOOST_AUTO_TEST_CASE(changes_at_the_start_and_at_the_end_are_events_of_their_own) {
  auto system = corridor(1);
  system.last = 1;
  system.starts_with = {{7, 0}};
  system.finishes_with = {{8, 1}, {9, 1}};
  const auto found = run(system, {0});
  BOOST_TEST(found.events == 3);
  BOOST_TEST((changes(found) == Changes{{7, 0}, {0, 1}, {8, 1}, {9, 1}}));
  BOOST_TEST(found.changes[0].time == 0);
  for (const std::size_t k : {1, 2, 3}) BOOST_TEST(found.changes[k].time == 1);
}

BOOST_AUTO_TEST_CASE(the_system_says_how_it_is_over) {
  for (const auto ending : {Ending::separated, Ending::captured}) {
    auto system = corridor(1);
    system.last = 1;
    system.ends = ending;
    BOOST_TEST((run(system, {0}).ending == ending));
  }
}

BOOST_AUTO_TEST_CASE(the_event_limit_counts_what_changes_at_the_start) {
  auto system = corridor(1);
  system.starts_with = {{7, 0}};
  const auto found = run(system, {0.25}, {.max_events = 1});
  BOOST_TEST((found.ending == Ending::event_limit));
  BOOST_TEST(found.time == 0);
  BOOST_TEST(found.state[0] == 0.25);
}

BOOST_AUTO_TEST_CASE(a_number_that_overflows_is_no_result) {
  Toy steep(
      2, [](ConstState, State dx) { dx[0] = 1, dx[1] = 1e308; }, 1,
      [](ConstState x, State g) { g[0] = x[0] - 10; }, {Crossing::rising});
  steep.ballistic = true;
  const auto found = run(single(steep), {0, 1});
  BOOST_TEST((found.ending == Ending::failed));
  BOOST_TEST(found.message == "a number is not finite");
  BOOST_TEST(found.state == (std::vector<double>{0, 1}), boost::test_tools::per_element());
  BOOST_TEST(found.time == 0);
}

BOOST_AUTO_TEST_CASE(the_time_limit_is_met_exactly_in_any_phase) {
  const auto found = run(corridor(1), {0}, {.max_time = 2.5});
  BOOST_TEST((found.ending == Ending::time_limit));
  BOOST_TEST(found.time == 2.5);
  BOOST_TEST(found.state[0] == 0.5);
  BOOST_TEST(found.events == 2);
}

BOOST_AUTO_TEST_CASE(an_event_at_the_time_limit_is_seen) {
  const auto found = run(corridor(1), {0}, {.max_time = 2});
  BOOST_TEST((found.ending == Ending::time_limit));
  BOOST_TEST(found.time == 2);
  BOOST_TEST(found.events == 2);
}

BOOST_AUTO_TEST_CASE(where_no_guard_can_cross_any_more_it_is_over) {
  ToySystem system{.phases = list(Ramp(1, {1}, {Crossing::rising}), Ramp(1, {0}, {Crossing::rising})),
                   .next = following};
  const auto found = run(system, {0});
  BOOST_TEST((found.ending == Ending::separated));
  BOOST_TEST(found.time == 1);
  BOOST_TEST(found.state[0] == 1);
  BOOST_TEST(found.message == "");
  // With a time limit there is something to wait for.
  const auto limited = run(system, {0}, {.max_time = 5});
  BOOST_TEST((limited.ending == Ending::time_limit));
  BOOST_TEST(limited.time == 5);
  BOOST_TEST(limited.state[0] == 5);
}

BOOST_AUTO_TEST_CASE(a_phase_may_end_itself_without_a_guard) {
  auto phase = Ramp(1, {2}, {Crossing::rising});
  phase.ballistic = false;  // closed forms ask nobody on the way
  phase.accepted = [](ConstState x) {
    return x[0] > 0.5 ? flow::Accepted::ended : flow::Accepted::unchanged;
  };
  const auto found = run(single(phase), {0});
  BOOST_TEST((found.ending == Ending::separated));
  BOOST_TEST((changes(found) == Changes{{-1, 1}}));
  BOOST_TEST(found.state[0] > 0.5);
  BOOST_TEST(found.state[0] < 2);
  BOOST_TEST(std::abs(found.time - found.state[0]) < 1e-10);  // the accuracy asked for
}

// A corridor so narrow that the clock does not tell how long it takes to cross.
BOOST_AUTO_TEST_CASE(modes_that_end_at_once_for_ever_are_a_failure) {
  ToySystem system{.phases = list(Ramp(1, {0}, {Crossing::rising}), Ramp(1, {1e-30}, {Crossing::rising}),
                                  Ramp(-1, {0}, {Crossing::falling})),
                   .next = [](Index mode, const auto&) { return mode == 1 ? Index{2} : Index{1}; }};
  const auto found = run(system, {-1});
  BOOST_TEST((found.ending == Ending::failed));
  BOOST_TEST(found.message == "contacts change without end at one instant");
  BOOST_TEST(found.time == 1);
}

BOOST_AUTO_TEST_CASE(a_failure_keeps_what_was_computed_before_the_phase_that_failed) {
  Toy broken(
      1, [](ConstState x, State dx) { dx[0] = x[0] > 1.5 ? std::nan("") : 1; }, 1,
      [](ConstState x, State g) { g[0] = x[0] - 2; }, {Crossing::rising});
  ToySystem system{.phases = list(Ramp(1, {1}, {Crossing::rising}), broken), .next = following};
  const auto found = run(system, {0});
  BOOST_TEST((found.ending == Ending::failed));
  BOOST_TEST(found.time == 1);
  BOOST_TEST(found.state[0] == 1);
  BOOST_TEST(found.events == 1);
  BOOST_TEST((changes(found) == Changes{{0, 1}}));
  BOOST_TEST_CONTEXT(found.message) BOOST_TEST(found.message.find("x0") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_flow_that_fails_is_replaced_from_the_start_of_the_phase) {
  Recorder recorder;
  const auto found = run(single(WithoutJacobian()), {0, 1}, {}, &recorder);
  BOOST_TEST((found.ending == Ending::separated));
  BOOST_TEST(found.message == "");
  BOOST_TEST(phases(found, flow::Kind::cvode_bdf_klu) == 1);
  BOOST_TEST(found.flows[static_cast<std::size_t>(flow::Kind::cvode_bdf_klu)].steps > 0);
  BOOST_TEST(phases(found, flow::Kind::cvode_adams) == 1);
  BOOST_TEST(recorder.begins == (std::vector<double>{0, 0}), boost::test_tools::per_element());
  BOOST_TEST(recorder.states[1] == (std::vector<double>{0, 1}), boost::test_tools::per_element());
  BOOST_TEST(std::abs(found.time - std::asin(0.5)) < 1e-10);
}

BOOST_AUTO_TEST_CASE(a_flow_asked_for_by_name_is_not_replaced_when_it_fails) {
  const auto found = run(single(WithoutJacobian()), {0, 1}, {.flow = flow::Kind::cvode_bdf_klu});
  BOOST_TEST((found.ending == Ending::failed));
  BOOST_TEST(!found.message.empty());
  BOOST_TEST(phases(found, flow::Kind::cvode_adams) == 0);
  BOOST_TEST(found.state == (std::vector<double>{0, 1}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_phase_too_stiff_for_a_flow_is_followed_on_from_where_it_has_come) {
  // δ creeps: but for a start of 1e-4 it is 1 − exp(−t/c), up to 1/c² [quasi-static limit].
  for (const auto& flow : {std::optional<flow::Kind>{}, std::optional{flow::Kind::taylor}}) {
    Recorder recorder;
    const auto found = run(single(Dashpot()), {0, 0, 0}, {.max_time = 20, .flow = flow}, &recorder);
    BOOST_TEST((found.ending == Ending::time_limit));
    BOOST_TEST(found.time == 20);
    BOOST_TEST(phases(found, flow::Kind::taylor) == 1);
    BOOST_TEST(phases(found, flow::Kind::cvode_bdf_klu) == 1);
    BOOST_REQUIRE(recorder.begins.size() == 2);
    BOOST_TEST(recorder.begins[1] > 0);
    BOOST_TEST(recorder.states[1][2] < 0);
    BOOST_TEST(recorder.joined);
    BOOST_TEST(std::abs(recorder.begins[1] + recorder.end - 20) <= 20 * epsilon);
    const double c = Dashpot::damping_constant, slow = 2 / (c + std::sqrt(c * c - 4)), fast = 1 / slow;
    const double exact = 1 + (slow * std::exp(-fast * 20) - fast * std::exp(-slow * 20)) / (fast - slow);
    BOOST_TEST(std::abs(-found.state[2] - exact) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(a_watcher_sees_each_phase_on_the_absolute_clock) {
  Recorder recorder;
  run(corridor(1), {0.25}, {.max_time = 2.5}, &recorder);
  BOOST_TEST(recorder.begins == (std::vector<double>{0, 0.75, 1.75}), boost::test_tools::per_element());
  BOOST_TEST(recorder.states[1][0] == 1);
  BOOST_TEST(recorder.states[2][0] == 0);
  BOOST_TEST(recorder.joined);
  BOOST_TEST(recorder.end == 0.75);
}

BOOST_AUTO_TEST_CASE(a_run_is_given_up_within_a_phase_where_its_last_step_ends) {
  struct Impatient : Recorder {
    bool gives_up() const override { return end > 3; }
  };
  Impatient impatient;
  const auto found = run(single(oscillator({2}, {Crossing::rising})), {0, 1}, {.max_time = 1e6}, &impatient);
  BOOST_TEST((found.ending == Ending::interrupted));
  BOOST_TEST(found.events == 0);
  BOOST_TEST(found.time == impatient.end);
  BOOST_TEST(found.time < 10);
  BOOST_TEST(std::abs(found.state[0] - std::sin(found.time)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_workspace_remembers_nothing_of_the_run_before) {
  hybrid::Workspace<ToySystem> workspace;
  auto fails = single(WithoutJacobian()), works = single(oscillator({0.5}, {Crossing::rising}));
  hybrid::simulate(fails, std::vector{0.0, 1.0}, {.flow = flow::Kind::cvode_bdf_klu}, workspace);
  const auto& again = hybrid::simulate(works, std::vector{0.0, 1.0}, {}, workspace);
  const auto fresh = run(works, {0, 1});
  BOOST_TEST((again.ending == Ending::separated));
  BOOST_TEST(again.message == "");
  BOOST_TEST(again.time == fresh.time);
  BOOST_TEST(again.state == fresh.state, boost::test_tools::per_element());
  BOOST_TEST(again.events == 1);
  for (const auto kind : flow::kinds) BOOST_TEST(phases(again, kind) == phases(fresh, kind));
}

BOOST_AUTO_TEST_CASE(a_flow_that_does_not_exist_is_refused_by_name) {
  BOOST_CHECK_EXCEPTION(flow::parse_kind("euler"), InvalidParameter, [](const InvalidParameter& refusal) {
    return std::string(refusal.what()).find("euler") != std::string::npos;
  });
}
