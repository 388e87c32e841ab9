// What every flow must do on every phase that it admits; a new flow is one more kind, a new kind of phase one
// more case of support/phases.hpp.
#define BOOST_TEST_MODULE conformance of flows
#include <boost/test/unit_test.hpp>
#include <set>

#include "support/field_reference.hpp"
#include "support/phases.hpp"

using namespace mariotte;
using namespace mariotte::test;
using flow::Kind;
using flow::Outcome;

namespace {

struct Result {
  flow::Arrival arrival;
  std::vector<double> x;
  std::vector<Index> fired;
};

Result follow(flow::Flow& flow, const Phase& phase, const flow::Request& request) {
  BOOST_REQUIRE(flow.admits(*phase.problem));
  Result result{{}, phase.x, {}};
  result.arrival = flow.follow(*phase.problem, result.x, request, result.fired);
  std::sort(result.fired.begin(), result.fired.end());
  return result;
}

Result follow(Kind kind, const PhaseCase& one, const flow::Request& request) {
  const auto phase = one.make();
  flow::Flows flows;
  return follow(flows.get(kind, *phase.problem), phase, request);
}

/// Largest error relative to what an error of 1 is.
double error(const flow::Problem& problem, ConstState found, ConstState exact) {
  double largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    largest = std::max(largest, std::abs(found[i] - exact[i]) / problem.magnitudes()[i]);
  return largest;
}

const std::vector<PhaseCase>& cases() {
  static const auto all = all_phases();
  return all;
}

/// State of a case after so much time or, if it comes before, at its first event, which lies near `end`.
PhaseEnd reference(const PhaseCase& one, double end, double limit) {
  const auto phase = one.make();
  return FieldReference(*phase.problem).follow(phase.x, end, limit);
}

/// First event of each case, found once: the second time with steps that shrink towards it.
const PhaseEnd& reference(const PhaseCase& one) {
  static std::map<std::string, PhaseEnd> known;
  if (const auto found = known.find(one.name); found != known.end()) return found->second;
  constexpr double late = 100;
  return known[one.name] = reference(one, reference(one, late, late).duration, late);
}

bool follows(Kind kind, const PhaseCase& one) {
  return name(kind).starts_with("cvode") ||
         std::find(one.special.begin(), one.special.end(), kind) != one.special.end();
}

/// `check(kind, case)` for every flow on every phase that it is to follow.
template <class Check>
void for_each_flow(const Check& check) {
  for (const auto& one : cases())
    for (const auto kind : flow::kinds)
      if (follows(kind, one)) BOOST_TEST_CONTEXT(one.name << " by " << name(kind)) check(kind, one);
}

/// What a observer sees of a phase.
struct Steps : flow::StepObserver {
  explicit Steps(const flow::Problem& followed) : problem(followed) {}

  void observe(const flow::Step& step) override {
    joined = joined && step.start == end && step.end >= step.start;
    end = step.end;
    last.assign(step.after.begin(), step.after.end());
    jump = std::max({jump, error(problem, at(step, step.start), step.before),
                     error(problem, at(step, step.end), step.after)});
    for (const double share : {0.25, 0.5, 0.75}) compare(step, step.start + share * (step.end - step.start));
  }

  const flow::Problem& problem;
  bool joined = true;
  double end = 0, jump = 0, against_field = 0;
  std::vector<double> last;

 private:
  static std::vector<double> at(const flow::Step& step, double time) {
    std::vector<double> x(step.before.size());
    step.at(time, x);
    return x;
  }
  /// Differences of the dense output with the field, but for what rounding does to differences.
  void compare(const flow::Step& step, double time) {
    const double h = 1e-4 * (step.end - step.start);
    const auto x = at(step, time), behind = at(step, time - h), ahead = at(step, time + h);
    std::vector<double> rate(x.size());
    problem.derivative(x, rate);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double rounding = 32 * epsilon * (std::abs(x[i]) + problem.magnitudes()[i]) / h;
      const double off = std::abs((ahead[i] - behind[i]) / (2 * h) - rate[i]) - rounding;
      against_field = std::max(against_field, off * problem.time_scale() / problem.magnitudes()[i]);
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_flow_has_a_phase_and_every_phase_an_event) {
  for (const auto kind : flow::kinds)
    BOOST_TEST(
        std::any_of(cases().begin(), cases().end(), [&](const auto& one) { return follows(kind, one); }));
  for (const auto& one : cases()) BOOST_TEST_CONTEXT(one.name) BOOST_TEST(!reference(one).fired.empty());
}

BOOST_AUTO_TEST_CASE(the_first_event_is_that_of_the_reference_as_accurately_as_asked) {
  for_each_flow([](Kind kind, const PhaseCase& one) {
    const auto& exact = reference(one);
    const auto phase = one.make();
    double first = 0, last = 0;
    for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const auto found = follow(kind, one, {.accuracy = accuracy});
      BOOST_TEST((found.arrival.outcome == Outcome::guard));
      BOOST_TEST(found.fired == exact.fired, boost::test_tools::per_element());
      BOOST_TEST(std::abs(found.arrival.duration - exact.duration) <= accuracy * phase.problem->time_scale());
      last = error(*phase.problem, found.x, exact.x);
      if (accuracy == 1e-4) first = last;
      BOOST_TEST(last <= accuracy);
    }
    // Six decades of accuracy give at least three of error, down to the error of the reference.
    BOOST_TEST(last <= std::max(1e-3 * first, 1e-12));
  });
}

BOOST_AUTO_TEST_CASE(the_time_limit_is_met_exactly) {
  for_each_flow([](Kind kind, const PhaseCase& one) {
    const double end = reference(one).duration;
    const auto phase = one.make();
    for (const double share : {0.3, 0.8, 1 - 1e-6}) {
      const double limit = share * end;
      const auto found = follow(kind, one, {.limit = limit, .accuracy = 1e-9});
      BOOST_TEST((found.arrival.outcome == Outcome::limit));
      BOOST_TEST(found.arrival.duration == limit);
      BOOST_TEST(found.fired.empty());
      BOOST_TEST(error(*phase.problem, found.x, reference(one, end, limit).x) <= 1e-9);
    }
    const auto found = follow(kind, one, {.limit = (1 + 1e-6) * end, .accuracy = 1e-9});
    BOOST_TEST((found.arrival.outcome == Outcome::guard));
  });
}

BOOST_AUTO_TEST_CASE(steps_join_and_their_dense_output_follows_the_field) {
  for_each_flow([](Kind kind, const PhaseCase& one) {
    const auto phase = one.make();
    Steps steps(*phase.problem);
    flow::Flows flows;
    const auto found = follow(flows.get(kind, *phase.problem), phase, {.accuracy = 1e-9, .observer = &steps});
    BOOST_TEST(steps.joined);
    BOOST_TEST(std::abs(steps.end - found.arrival.duration) <= 4 * epsilon * steps.end);
    BOOST_TEST(error(*phase.problem, steps.last, found.x) <= 4 * epsilon);
    BOOST_TEST(steps.jump <= 1e-12);  // at an end of a step, which is a root of some clocks
    BOOST_TEST(steps.against_field <=
               1e-6);  // differences, and an interpolant's slope is worse than its value
  });
}

BOOST_AUTO_TEST_CASE(the_same_phase_gives_the_same_bits_from_new_and_from_used_memory) {
  for_each_flow([](Kind kind, const PhaseCase& one) {
    const auto fresh = follow(kind, one, {});
    flow::Flows flows;
    for (int time = 0; time < 2; ++time) {
      const auto phase = one.make();
      const auto again = follow(flows.get(kind, *phase.problem), phase, {});
      BOOST_TEST(again.arrival.duration == fresh.arrival.duration);
      BOOST_TEST(again.arrival.steps == fresh.arrival.steps);
      BOOST_TEST(again.x == fresh.x, boost::test_tools::per_element());
      BOOST_TEST(again.fired == fresh.fired, boost::test_tools::per_element());
    }
  });
}

BOOST_AUTO_TEST_CASE(a_guard_that_is_zero_at_the_start_does_not_fire_there) {
  std::set<Kind> asked;
  for_each_flow([&](Kind kind, const PhaseCase& one) {
    const auto phase = one.make();
    std::vector<double> value(phase.problem->guard_count());
    phase.problem->guards(phase.x, value);
    bool starts_at_zero = false;
    for (std::size_t i = 0; i < value.size(); ++i)
      starts_at_zero |= value[i] == 0 && phase.problem->crossings()[i] != flow::Crossing::none;
    if (!starts_at_zero) return;
    asked.insert(kind);
    BOOST_TEST(follow(kind, one, {}).arrival.duration > 0.1 * phase.problem->time_scale());
  });
  BOOST_TEST(asked.size() == flow::kinds.size());
}

BOOST_AUTO_TEST_CASE(a_flow_refuses_what_it_cannot_follow) {
  for (const auto& one : cases()) {
    const auto phase = one.make();
    const auto& problem = *phase.problem;
    flow::Flows flows;
    for (const auto kind : flow::kinds) BOOST_TEST_CONTEXT(one.name << " by " << name(kind)) {
        if (problem.is_ballistic())  // nobody else is asked
          BOOST_TEST((flows.choose(problem, kind).kind == Kind::ballistic));
        else
          BOOST_TEST(flows.get(kind, problem).admits(problem) == follows(kind, one));
      }
  }
}

BOOST_AUTO_TEST_CASE(series_follow_rows_of_any_length) {
  std::vector<double> velocity;
  for (int i = 0; i < 100; ++i) velocity.push_back(-0.1 * i - 0.05 * std::sin(i));
  const auto phase = phase_of(equal_masses(std::vector<contact::Law>(99, contact::Hertz{1}), velocity));
  const auto end_by = [&](Kind kind) {
    flow::Flows flows;
    const auto result = follow(flows.get(kind, *phase.problem), phase, {.limit = 0.4});
    BOOST_TEST((result.arrival.outcome == Outcome::limit));
    return result.x;
  };
  BOOST_TEST(error(*phase.problem, end_by(Kind::taylor), end_by(Kind::cvode_adams)) < 1e-9);
}
