#define BOOST_TEST_MODULE the gate
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/chain/chain_gate.hpp"

using namespace mariotte;
using contact::ContactMode;
using hybrid::Ending;
using impact::Balance;

namespace {

struct Passed {
  Ending ending;
  std::string message;
};

Passed passed(std::vector<Balance> balances, Ending ending = Ending::separated) {
  Passed result{ending, {}};
  impact::pass_gate(balances, result.ending, result.message);
  return result;
}

/// An automaton that forgets the first contact.
struct Forgetful : model::ChainSystem {
  void mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const {
    ChainSystem::mode_at(x, mode, changes);
    mode[0] = ContactMode::open;
    changes.clear();
  }
};

/// An automaton whose first contact has let go, whatever presses it.
struct Slackening : model::ChainSystem {
  void mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const {
    ChainSystem::mode_at(x, mode, changes);
    mode[0] = ContactMode::slack;
    changes.clear();
  }
};

/// The real one, its state pushed by `push` at the end.
template <class System>
Passed run(const model::Chain& chain, double end, Index component = 0, double push = 0) {
  System system;
  system.reset(chain, 1e-10, /*stay=*/std::isfinite(end));
  std::vector<double> start;
  initial_state(system.chain(), system.layout(), start);
  hybrid::Workspace<System> workspace;
  hybrid::simulate(system, start, hybrid::scaled({.max_time = end}, system.chain().scale), workspace);
  auto& run = workspace.run;
  run.state[static_cast<std::size_t>(component)] += push;
  const impact::Interval interval{.before = start, .after = run.state, .time = run.time};
  std::vector<double> p;
  std::vector<Index> periods;
  std::vector<impact::ContactEnergy> energies;
  impulses(system.chain(), system.layout(), interval, p);
  impact::count_periods(run.changes, system.layout().contacts(), periods);
  contact_energies(system.chain(), system.layout(), workspace.mode, interval, energies);
  Passed result{run.ending, run.message};
  impact::pass_gate({system.chain(), system.layout(), workspace.mode, interval, p, periods, energies}, 1e-10,
                    result.ending, result.message);
  return result;
}

const contact::Law hertz = contact::Hertz{1},
                   damped = contact::Viscoelastic{.stiffness = 1, .damping = 0.2, .exponent = 1.5};

model::Chain on_a_floor(const contact::Law& law) {
  return {.mass = {infinity, 1, 1}, .law = {law, law}, .gap = {0, 0}, .velocity = {0, 0, 0}, .gravity = 0.1};
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_balances_passes) {
  const auto result = passed({{"energy", 1e-12, 1e-11}, {"momentum", -1e-12, 1e-11}});
  BOOST_TEST((result.ending == Ending::separated));
  BOOST_TEST(result.message.empty());
}

BOOST_AUTO_TEST_CASE(the_worst_balance_is_named_with_its_size) {
  const auto result = passed({{"energy", 2e-11, 1e-11}, {"momentum", -3e-9, 1e-11}});
  BOOST_TEST((result.ending == Ending::unsure));
  BOOST_TEST(result.message.find("momentum is off by 3e-09") != std::string::npos, result.message);
}

BOOST_AUTO_TEST_CASE(what_is_not_a_number_does_not_balance) {
  for (const double size : {double(NAN), infinity}) {
    BOOST_TEST((passed({{"energy", size, 1}}).ending == Ending::unsure));
    BOOST_TEST((passed({{"energy", 0, NAN}}).ending == Ending::unsure));
  }
}

BOOST_AUTO_TEST_CASE(a_limit_does_not_excuse_but_a_failure_stays_one) {
  BOOST_TEST((passed({{"energy", 1, 0.1}}, Ending::time_limit).ending == Ending::unsure));
  BOOST_TEST((passed({{"energy", 1, 0.1}}, Ending::failed).ending == Ending::failed));
}

BOOST_AUTO_TEST_CASE(a_floor_that_is_forgotten_is_noticed) {
  for (const auto& law : {hertz, damped}) {
    BOOST_TEST((run<model::ChainSystem>(on_a_floor(law), 5).ending == Ending::time_limit));
    const auto result = run<Forgetful>(on_a_floor(law), 5);
    BOOST_TEST((result.ending == Ending::unsure), result.message);
  }
}

BOOST_AUTO_TEST_CASE(a_contact_that_has_let_go_and_is_pressed_is_noticed) {
  const model::Chain pressed{
      .mass = {1, 1}, .law = {damped}, .gap = {-0.1}, .velocity = {1, 0}, .precompressed = true};
  BOOST_TEST((run<model::ChainSystem>(pressed, 0.05).ending == Ending::time_limit));
  const auto result = run<Slackening>(pressed, 0.05);
  BOOST_TEST((result.ending == Ending::unsure), result.message);
}

BOOST_AUTO_TEST_CASE(velocities_that_are_off_are_noticed) {
  const model::Chain cradle{.mass = {1, 1, 1}, .law = {hertz, hertz}, .gap = {0, 0}, .velocity = {1, 0, 0}};
  BOOST_TEST((run<model::ChainSystem>(cradle, infinity).ending == Ending::separated));
  for (const double push : {1e-6, -1e-6, double(NAN)})
    BOOST_TEST((run<model::ChainSystem>(cradle, infinity, 4, push).ending == Ending::unsure));
}
