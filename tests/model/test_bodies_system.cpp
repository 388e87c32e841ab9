// The automaton of contacts of bodies.
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/jkr.hpp"
#include "mariotte/contact/named_laws.hpp"
#include "mariotte/model/bodies/bodies_system.hpp"
#include "support/random_balls.hpp"

using namespace mariotte;
using namespace mariotte::model;

namespace {

/// A ball that has met the plane below it, and slips.
struct Stage {
  Bodies bodies;
  BodiesSystem<2> system;
  std::vector<double> x;
  BodiesMode mode;
  std::vector<BodiesChange> changes;

  explicit Stage(const contact::Law& law)
      : bodies(scene(law)),
        system(bodies, setting_of<2>(bodies, 1e-9), Over::separated),
        x(initial_state(bodies, system.setting())) {
    system.mode_at(x, mode, changes);
  }

  static Bodies scene(const contact::Law& law) {
    Bodies bodies{.dimension = 2};
    bodies.body = {test::ball({0, test::radius, 0})};
    bodies.body[0].velocity = {0.3, -1, 0};
    bodies.plane = {{.name = "", .point = {}, .normal = {0, 1, 0}, .velocity = {}}};
    bodies.contact = {
        {.a = {0, -1}, .b = {0, 0}, .law = law, .tangential = {TangentialLaw::spring, 0.1, 1e5}}};
    return bodies;
  }

  /// Parting, just where the load has changed its sign.
  void put_behind_the_end_of_the_load() {
    const auto at = system.layout(x);
    mode.closed[0].unloading = true;
    mode.closed[0].slack = false;
    x[at.velocity(0) + 1] = 1;
    double pressed = -1e-3, parted = 0;
    for (int i = 0; i < 60; ++i) {
      const double middle = x[at.shift(0) + 1] = 0.5 * (pressed + parted);
      (system.field(mode, x).contact(0).normal < 0 ? parted : pressed) = middle;
    }
    x[at.shift(0) + 1] = parted;
  }
};

}  // namespace

// Where a slip begins next to the end of the load, the guard of that end has passed zero already.
BOOST_AUTO_TEST_CASE(what_lets_go_where_another_guard_fires_is_slack) {
  const contact::Law laws[] = {contact::state(contact::Jkr(1e9, test::radius, 0.5, 0)),
                               contact::Viscoelastic{.stiffness = 1e6, .damping = 1e3, .exponent = 1.5}};
  for (const auto& law : laws) {
    Stage stage(law);
    BOOST_REQUIRE(!stage.mode.closed.empty());
    stage.put_behind_the_end_of_the_load();
    BOOST_REQUIRE(stage.system.field(stage.mode, stage.x).contact(0).normal < 0);
    const Index slot = stage.mode.closed[0].slot;
    stage.system.problem(stage.mode);
    stage.system.transition(stage.mode, {guards_per_slot * slot + static_cast<Index>(SlotGuard::friction)},
                            stage.x, stage.changes);
    BOOST_TEST(stage.mode.closed[0].slack);
    BOOST_TEST((stage.changes.back().event == BodyEvent::slack));
  }
}
