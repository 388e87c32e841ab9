// A phase in which nothing happens ends nevertheless; ten million steps take ten seconds.
#define BOOST_TEST_MODULE hybrid_step_limit
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/hybrid/simulate.hpp"
#include "support/toy_system.hpp"

using namespace mariotte;
using namespace mariotte::test;

BOOST_AUTO_TEST_CASE(a_phase_whose_guard_never_fires_fails_at_the_step_limit) {
  // x = sin t never reaches 2, which no flow of any field can know.
  ToySystem system{.phases = {std::make_shared<Toy>(oscillator({2}, {flow::Crossing::rising}))},
                   .next = following,
                   .last = 1};
  hybrid::Workspace<ToySystem> workspace;
  const auto& run = hybrid::simulate(system, std::vector{0.0, 1.0}, {.accuracy = 1e-2}, workspace);
  BOOST_TEST((run.ending == hybrid::Ending::failed));
  BOOST_TEST(run.message.find(flow::exhaustion) == 0);
  // BDF tries after the usual steps, takes no longer ones and gives back; what has been followed until then
  // stays.
  const auto& adams = run.flows[static_cast<std::size_t>(flow::Kind::cvode_adams)];
  BOOST_TEST(adams.steps == flow::Request::usual_steps + 1 + flow::most_steps_of_phase);
  BOOST_TEST(adams.phases == 2);
  BOOST_TEST(run.time > 1000);
  BOOST_TEST(std::abs(run.state[0] - std::sin(run.time)) < 1e-2);
  BOOST_TEST(std::abs(run.state[1] - std::cos(run.time)) < 1e-2);
}
