// The automaton is one: a chain and the same chain written as a network follow the same rules, but for those
// whose reasons are given here.
#define BOOST_TEST_MODULE automaton of chains and networks
#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include "mariotte/hybrid/system.hpp"
#include "mariotte/model/chain/chain_system.hpp"
#include "mariotte/model/network/network_system.hpp"
#include "support/custom_power_law.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;
using contact::ContactMode;
using model::ChainSystem;
using model::NetworkSystem;

static_assert(hybrid::HybridSystem<NetworkSystem>);

namespace {

constexpr double accuracy = 1e-10;
const contact::Law hertz = contact::Hertz{1},
                   damped = contact::Viscoelastic{.stiffness = 1, .damping = 0.5, .exponent = 1};

std::unique_ptr<ChainSystem> make(const model::Chain& chain, ChainSystem*) {
  auto system = std::make_unique<ChainSystem>();
  system->reset(chain, accuracy, false);
  return system;
}
std::unique_ptr<NetworkSystem> make(const model::Chain& chain, NetworkSystem*) {
  return std::make_unique<NetworkSystem>(model::as_network(chain), accuracy);
}
const model::ScaledContacts& contacts(const ChainSystem& system) {
  return system.chain();
}
const model::ScaledContacts& contacts(const NetworkSystem& system) {
  return system.network();
}

template <class System>
struct Fixture {
  std::unique_ptr<System> system;
  std::vector<double> x{};
  std::vector<model::ContactChange> changes{};
  contact::ContactSet mode{};

  explicit Fixture(const model::Chain& chain) : system(make(chain, static_cast<System*>(nullptr))) {
    initial_state(contacts(*system), system->layout(), x);
    system->mode_at(x, mode, changes);
  }
  void set(Index contact, double gap, double approach) {
    x[system->layout().gap[contact]] = gap;
    x[system->layout().velocity[contact]] = x[system->layout().velocity[contact + 1]] + approach;
  }
  void fire(const std::vector<Index>& guards) { system->transition(mode, guards, x, changes); }
  void expect(const std::vector<ContactMode>& modes) { BOOST_TEST((mode == modes)); }
};

model::Chain pair(contact::Law law) {
  return equal_masses({std::move(law)}, {1, 0});
}

using Systems = boost::mpl::list<ChainSystem, NetworkSystem>;

}  // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(what_sinks_into_noise_fades_whichever_way_it_moves, System, Systems) {
  for (const double approach : {-1e-13, 1e-13}) {
    Fixture<System> f(pair(hertz));
    f.set(0, -1e-11, approach);
    BOOST_TEST((f.system->problem(f.mode).accept(f.x) == flow::Accepted::ended));
    f.fire({});
    f.expect({ContactMode::hovering});
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_contact_that_has_just_closed_has_not_faded, System, Systems) {
  Fixture<System> f(pair(hertz));
  f.mode = {ContactMode::hovering};
  f.set(0, -1e-11, 1e-13);
  f.fire({0});
  f.expect({ContactMode::closed});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(what_has_left_the_noise_by_an_event_is_closed, System, Systems) {
  Fixture<System> f(equal_masses({hertz, hertz}, {1, 0, 0}));
  f.expect({ContactMode::closed, ContactMode::touching});
  f.set(1, -1e-6, 0.1);
  f.fire({});
  f.expect({ContactMode::closed, ContactMode::closed});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(what_touched_and_is_drawn_apart_has_parted, System, Systems) {
  Fixture<System> f(equal_masses({hertz, hertz}, {1, 0, 0}));
  f.set(1, 1e-6, -0.1);
  BOOST_TEST((f.system->problem(f.mode).accept(f.x) == flow::Accepted::ended));
  f.fire({});
  f.expect({ContactMode::closed, ContactMode::open});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_slack_contact_that_a_neighbour_presses_pushes_again, System, Systems) {
  // Its load is past zero by rounding, and ball 2 is pushed from the right: no guard would tell.
  Fixture<System> f(equal_masses({damped, damped}, {0, 0, -1}));
  f.mode = {ContactMode::slack, ContactMode::closed};
  f.set(1, -0.3, 0.5);
  f.set(0, -0.1, -0.2 + 1e-16);
  f.fire({});
  f.expect({ContactMode::closed, ContactMode::closed});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_gap_that_opens_with_its_load_is_open, System, Systems) {
  for (const auto mode : {ContactMode::closed, ContactMode::slack}) {
    Fixture<System> f(pair(damped));
    f.mode = {mode};
    f.set(0, 0, -0.1);
    f.fire({0, 1});
    f.expect({ContactMode::open});
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_row_at_rest_is_pressed_as_a_whole, System, Systems) {
  Fixture<System> f(equal_masses({hertz, hertz, hertz, hertz}, {1, 0, 0, 0, 0}));
  f.expect({ContactMode::closed, ContactMode::touching, ContactMode::touching, ContactMode::touching});
  BOOST_TEST(f.changes.size() == 4u);
}

// Where laws have no linear load, the end of a damped contact is watched as a gap, too.
BOOST_AUTO_TEST_CASE_TEMPLATE(only_cvode_sees_a_law_of_ones_own, System, Systems) {
  const auto own = custom({.stiffness = 1, .damping = 0.5, .exponent = 1.5});
  Fixture<System> f(equal_masses({own, hertz}, {1, 0, -1}));
  auto& phase = f.system->problem(f.mode);
  BOOST_TEST(!phase.serial());
  BOOST_TEST((phase.crossings()[0] == flow::Crossing::rising));
  BOOST_TEST((phase.crossings()[2] == flow::Crossing::falling));
  f.mode = {ContactMode::open, ContactMode::closed};
  BOOST_TEST(f.system->problem(f.mode).serial());
  f.mode = {ContactMode::slack, ContactMode::open};
  BOOST_TEST(!f.system->problem(f.mode).serial());
  BOOST_TEST(!f.system->problem(f.mode).is_ballistic());  // its load is not linear in the state
}

BOOST_AUTO_TEST_CASE_TEMPLATE(rates_of_guards_agree_with_differences, System, Systems) {
  Fixture<System> f(
      equal_masses({damped, custom({.stiffness = 2, .damping = 0.3, .exponent = 1.5})}, {1, 0, -1}));
  f.mode = {ContactMode::closed, ContactMode::closed};
  f.set(1, -0.2, 0.4);
  f.set(0, -0.1, 0.3);
  auto& phase = f.system->problem(f.mode);
  const auto n = static_cast<std::size_t>(phase.guard_count());
  std::vector<double> dx(f.x.size()), rates(n), before(n), after(n);
  phase.derivative(f.x, dx);
  phase.guard_rates(f.x, dx, rates);
  constexpr double step = 1e-6;
  auto x = f.x;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = f.x[i] - step * dx[i];
  phase.guards(x, before);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = f.x[i] + step * dx[i];
  phase.guards(x, after);
  for (std::size_t i = 0; i < n; ++i)
    BOOST_TEST(std::abs(rates[i] - (after[i] - before[i]) / (2 * step)) < 1e-8);
}

// Gap rates of a network are sums of products, so that equal velocities need not give exactly 0; those of a
// chain are one difference, so that they do.
BOOST_AUTO_TEST_CASE(rounding_of_gap_rates_is_rest_in_a_network_only) {
  const auto row = equal_masses({hertz, hertz}, {1, 1e-16, 0});
  Fixture<NetworkSystem>(row).expect({ContactMode::closed, ContactMode::touching});
  Fixture<ChainSystem>(row).expect({ContactMode::closed, ContactMode::closed});
}
