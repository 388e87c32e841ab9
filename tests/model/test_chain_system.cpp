#define BOOST_TEST_MODULE chain as a hybrid system
#include <boost/test/unit_test.hpp>

#include "mariotte/hybrid/system.hpp"
#include "mariotte/model/chain/chain_system.hpp"
#include "support/reference.hpp"

using namespace mariotte;
using namespace mariotte::test;
using contact::ContactMode;
using model::ChainSystem;

static_assert(hybrid::HybridSystem<ChainSystem>);

namespace {

const contact::Law hertz = contact::Hertz{1},
                   damped = contact::Viscoelastic{.stiffness = 1, .damping = 0.5, .exponent = 1};

struct Fixture {
  model::Chain chain;
  ChainSystem system{};
  std::vector<double> x{};
  std::vector<model::ContactChange> changes{};

  explicit Fixture(const model::Chain& one) : chain(one) {
    system.reset(chain, 1e-10, false);
    initial_state(system.chain(), system.layout(), x);
  }
  ChainSystem::Mode start() {
    ChainSystem::Mode mode;
    system.mode_at(x, mode, changes);
    return mode;
  }
  ChainSystem::Mode after(ChainSystem::Mode mode, std::vector<Index> fired) {
    changes.clear();
    system.transition(mode, fired, x, changes);
    return mode;
  }
  void set(Index contact, double gap, double approach) {
    x[system.layout().gap[contact]] = gap;
    x[system.layout().velocity[contact]] = approach;
    x[system.layout().velocity[contact + 1]] = 0;
  }
};

Fixture pair(contact::Law law) {
  return Fixture(equal_masses({law}, {1, 0}));
}

void check_modes(const ChainSystem::Mode& mode, const std::vector<ContactMode>& expected) {
  BOOST_TEST((mode == expected));
}

}  // namespace

// The rows of the table in contact/contact_set.hpp, guard 0 being the gap and guard 1 the load.
BOOST_AUTO_TEST_CASE(open_to_closed_when_the_gap_falls_through_zero) {
  auto f = pair(hertz);
  check_modes(f.after({ContactMode::open}, {0}), {ContactMode::closed});
}
BOOST_AUTO_TEST_CASE(closed_to_open_when_the_gap_rises_through_zero) {
  auto f = pair(hertz);
  check_modes(f.after({ContactMode::closed}, {0}), {ContactMode::open});
}
BOOST_AUTO_TEST_CASE(closed_to_slack_when_the_load_falls_through_zero_while_indented) {
  auto f = pair(damped);
  f.set(0, -0.1, -0.2);
  check_modes(f.after({ContactMode::closed}, {1}), {ContactMode::slack});
}
BOOST_AUTO_TEST_CASE(slack_to_closed_when_the_load_rises_through_zero) {
  auto f = pair(damped);
  f.set(0, -0.1, -0.2);
  check_modes(f.after({ContactMode::slack}, {1}), {ContactMode::closed});
}
BOOST_AUTO_TEST_CASE(slack_to_open_when_the_gap_rises_through_zero) {
  auto f = pair(damped);
  check_modes(f.after({ContactMode::slack}, {0}), {ContactMode::open});
}
BOOST_AUTO_TEST_CASE(open_to_touching_for_a_resting_row_that_is_pressed) {
  Fixture f{equal_masses({hertz, hertz, hertz, hertz}, {1, 0, 0, 0, 0.5})};
  check_modes(f.start(),
              {ContactMode::closed, ContactMode::touching, ContactMode::touching, ContactMode::open});
  BOOST_TEST(f.changes.size() == 3u);
}
BOOST_AUTO_TEST_CASE(touching_to_closed_when_the_indentation_has_left_the_noise) {
  Fixture f{equal_masses({hertz, hertz}, {1, 0, 0})};
  auto mode = f.start();
  auto& phase = f.system.problem(mode);
  f.x[f.system.layout().gap[1]] = -1e-14;
  BOOST_TEST((phase.accept(f.x) == flow::Accepted::unchanged));
  check_modes(mode, {ContactMode::closed, ContactMode::touching});
  f.x[f.system.layout().gap[1]] = -1e-6;
  BOOST_TEST((phase.accept(f.x) == flow::Accepted::rewatched));
  check_modes(mode, {ContactMode::closed, ContactMode::closed});
}

BOOST_AUTO_TEST_CASE(open_to_hovering_when_the_approach_may_be_rounding) {
  auto f = pair(hertz);
  f.set(0, 0, 1e-13);
  check_modes(f.after({ContactMode::open}, {0}), {ContactMode::hovering});
  check_modes(f.after({ContactMode::hovering}, {0}), {ContactMode::closed});
}
BOOST_AUTO_TEST_CASE(closed_to_hovering_when_what_is_left_is_noise) {
  auto f = pair(hertz);
  ChainSystem::Mode mode = {ContactMode::closed};
  auto& phase = f.system.problem(mode);
  f.set(0, -1e-11, 1e-3);  // deepening, not slowly
  BOOST_TEST((phase.accept(f.x) == flow::Accepted::unchanged));
  f.set(0, -1e-11, -1e-3);  // parting, not slowly
  BOOST_TEST((phase.accept(f.x) == flow::Accepted::unchanged));
  for (const double approach : {-1e-13, 1e-13}) {
    f.set(0, -1e-11, approach);
    BOOST_TEST((phase.accept(f.x) == flow::Accepted::ended));
    check_modes(f.after(mode, {}), {ContactMode::hovering});
    BOOST_TEST(f.changes.size() == 1u);
  }
}

BOOST_AUTO_TEST_CASE(a_row_struck_later_is_pressed_as_a_whole) {
  Fixture f{equal_masses({hertz, hertz, hertz}, {1, 0, 0, 0})};
  f.x[f.system.layout().gap[0]] = 1;
  auto mode = f.start();
  check_modes(mode, {ContactMode::open, ContactMode::open, ContactMode::open});
  f.x[f.system.layout().gap[0]] = 0;
  check_modes(f.after(mode, {0}), {ContactMode::closed, ContactMode::touching, ContactMode::touching});
}

BOOST_AUTO_TEST_CASE(a_set_of_contacts_changes_in_one_transition) {
  Fixture f{equal_masses({hertz, hertz}, {1, 0, -1})};
  const auto mode = f.start();
  check_modes(mode, {ContactMode::closed, ContactMode::closed});
  check_modes(f.after(mode, {0, 1}), {ContactMode::open, ContactMode::open});
  BOOST_TEST(f.changes.size() == 2u);
}

BOOST_AUTO_TEST_CASE(touching_balls_that_part_or_rest_are_open) {
  Fixture f{equal_masses({hertz, hertz}, {0, 1, 1})};
  check_modes(f.start(), {ContactMode::open, ContactMode::open});
  BOOST_TEST(f.system.is_over(f.start(), f.x, false));
}

BOOST_AUTO_TEST_CASE(indented_damped_contacts_start_slack_if_they_would_pull) {
  Fixture f{{.mass = {1, 1}, .law = {damped}, .gap = {-0.1}, .velocity = {-1, 0}, .precompressed = true}};
  check_modes(f.start(), {ContactMode::slack});
}

BOOST_AUTO_TEST_CASE(an_approaching_pair_is_not_over_and_a_parting_one_is) {
  auto f = pair(hertz);
  f.set(0, 1, 0.5);
  BOOST_TEST(!f.system.is_over({ContactMode::open}, f.x, true));
  f.set(0, 1, -0.5);
  BOOST_TEST(f.system.is_over({ContactMode::open}, f.x, true));
  BOOST_TEST(!f.system.is_over({ContactMode::closed}, f.x, true));
}

BOOST_AUTO_TEST_CASE(gravity_above_a_wall_is_not_over_before_the_first_impact) {
  Fixture f{{.mass = {infinity, 1}, .law = {hertz}, .gap = {1}, .velocity = {0, 0}, .gravity = 9.81}};
  BOOST_TEST(!f.system.is_over({ContactMode::open}, f.x, false));
  f.set(0, 1, -0.1);
  BOOST_TEST(f.system.is_over({ContactMode::open}, f.x, true));
}

BOOST_AUTO_TEST_CASE(a_ball_that_rests_on_a_wall_has_not_parted_from_it) {
  Fixture f{{.mass = {infinity, 1}, .law = {hertz}, .gap = {0}, .velocity = {0, 0}, .gravity = 9.81}};
  for (const auto mode : {ContactMode::touching, ContactMode::open, ContactMode::hovering})
    BOOST_TEST(!f.system.is_over({mode}, f.x, true));
}

BOOST_AUTO_TEST_CASE(the_jacobian_agrees_with_differences) {
  const contact::Law soft = contact::Viscoelastic{.stiffness = 2, .damping = 0.3, .exponent = 1.5};
  model::Chain chain{.mass = {infinity, 1, 2, 3},
                     .law = {hertz, damped, soft},
                     .gap = {0, 0, 0},
                     .velocity = {0, -1, -0.5, -2}};
  Fixture f{chain};
  auto mode = f.start();
  auto& phase = f.system.problem(mode);
  for (const Index j : {0, 1, 2}) f.x[f.system.layout().gap[j]] = -0.1 * static_cast<double>(j + 1);
  const auto n = static_cast<std::size_t>(phase.size());
  std::vector<double> values(phase.pattern().size()), full(n * n, 0.0), up(n), down(n);
  phase.jacobian(f.x, values);
  for (std::size_t e = 0; e < values.size(); ++e)
    full[static_cast<std::size_t>(phase.pattern()[e].row) * n +
         static_cast<std::size_t>(phase.pattern()[e].column)] += values[e];
  for (std::size_t j = 0; j < n; ++j) {
    auto x = f.x;
    x[j] += 1e-6, phase.derivative(x, up);
    x[j] -= 2e-6, phase.derivative(x, down);
    for (std::size_t i = 0; i < n; ++i)
      BOOST_TEST(std::abs(full[i * n + j] - (up[i] - down[i]) / 2e-6) < 1e-8);
  }
}
