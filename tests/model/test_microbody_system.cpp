// The automaton of a tip, row by row of its table.
#define BOOST_TEST_MODULE model_microbody_system
#include <boost/test/unit_test.hpp>

#include "mariotte/model/microbody/microbody_field.hpp"
#include "mariotte/model/microbody/microbody_system.hpp"
#include "support/reference_bodies.hpp"

using namespace mariotte;
using namespace mariotte::model;

namespace {

/// A rod that lies tilted by β in the plane of e1 and e3.
Microbody rod_at(double beta, double friction) {
  Microbody body;
  body.body = rod(2.45e-6, 10, test::density);
  body.law.assign(2, contact::brach_dunn(test::table_1, 2.45e-6, 0.007, 0.0087));
  body.friction = {friction};
  body.attitude = from_euler({0, beta, 0});
  body.velocity = {-5, 0, 0};
  return body;
}

struct Stage {
  MicrobodySystem system;
  std::vector<double> x;
  MicrobodyMode mode;
  std::vector<MicrobodyChange> changes;

  explicit Stage(const Microbody& body)
      : system(body, 1e-9, true), x(initial_state(system.body(), system.layout())) {}

  TipMode& tip() { return mode.tip[0]; }
  void put_gap(double gap) { x[system.layout().place.gap[0]] = gap; }
  void put_velocity(const Vector3& v) { put(x, system.layout().place.velocity, v); }
  void start() { system.mode_at(x, mode, changes); }
  void fire(TipGuard guard) { fire({guard_index(0, guard)}); }
  void fire(const std::vector<Index>& guards) {
    changes.clear();
    system.transition(mode, guards, x, changes);
  }
  bool said(TipEvent event) const {
    return std::any_of(changes.begin(), changes.end(), [&](const auto& one) { return one.event == event; });
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_tip_that_touches_at_rest_sticks_if_friction_can_hold_it) {
  Stage held(rod_at(0.7, 2.0)), slips(rod_at(0.7, 0.1));
  held.start();
  slips.start();
  BOOST_TEST(held.said(TipEvent::close));
  BOOST_TEST(held.said(TipEvent::stick));
  BOOST_TEST((held.tip().contact == TipContact::sticking));
  BOOST_TEST(slips.said(TipEvent::slip));
  BOOST_TEST((slips.tip().start == SlipStart::turning));
  BOOST_TEST(slips.tip().at_touch);
}

BOOST_AUTO_TEST_CASE(a_tip_that_touches_moving_slides_without_an_event_of_its_own) {
  auto body = rod_at(0.7, 2.0);
  body.velocity.e3 = 1;
  Stage stage(body);
  stage.start();
  BOOST_TEST((stage.tip().contact == TipContact::sliding));
  BOOST_TEST((stage.tip().start == SlipStart::moving));
  BOOST_TEST(stage.tip().direction.e3 == 1);
  BOOST_TEST(!stage.said(TipEvent::slip));
}

BOOST_AUTO_TEST_CASE(adhesion_pulls_first_unless_its_damping_is_stronger) {
  Stage pulled(rod_at(0.7, 0.1));
  pulled.start();
  BOOST_TEST(pulled.tip().force_sign == -1);
  auto body = rod_at(0.7, 0.1);
  for (auto& law : body.law) law.damping_adhesion = 0.5;  // C_A v₀ = 2.5
  Stage pushed(body);
  pushed.start();
  BOOST_TEST(pushed.tip().force_sign == 1);
}

BOOST_AUTO_TEST_CASE(a_closed_tip_whose_gap_rises_is_clear_and_has_had_its_impact) {
  for (const auto contact : {TipContact::sliding, TipContact::sticking}) {
    Stage stage(rod_at(0.7, 0.1));
    stage.tip().contact = contact;
    stage.put_velocity({1, 0, 0});
    stage.fire(TipGuard::gap);
    BOOST_TEST((stage.tip().contact == TipContact::clear));
    BOOST_TEST(stage.mode.impacts == 1);
    BOOST_TEST(stage.said(TipEvent::open));
    BOOST_TEST(stage.system.is_over(stage.mode, stage.x, true));
    BOOST_TEST((stage.system.ending(stage.mode) == hybrid::Ending::separated));
  }
}

// A tip that sticks until it opens may reach its cone at the same instant: it must not slip in the air.
BOOST_AUTO_TEST_CASE(a_tip_that_opens_is_clear_whatever_else_fires_with_it) {
  for (const auto guard : {TipGuard::force, TipGuard::slip, TipGuard::cone, TipGuard::turn_back}) {
    Stage stage(rod_at(0.7, 0.1));
    stage.tip().contact = TipContact::sticking;
    stage.put_velocity({1, 0, 0});
    stage.fire({guard_index(0, TipGuard::gap), guard_index(0, guard)});
    BOOST_TEST((stage.tip().contact == TipContact::clear));
    BOOST_TEST(!stage.mode.captured);
    BOOST_TEST(stage.mode.impacts == 1);
    BOOST_TEST((stage.changes.back().event == TipEvent::open));
  }
}

BOOST_AUTO_TEST_CASE(friction_changes_sides_with_the_sign_of_the_force) {
  Stage stage(rod_at(0.7, 0.1));
  stage.start();
  stage.put_gap(-0.1);
  stage.put_velocity({-1, 0, stage.tip().direction.e3});
  stage.fire(TipGuard::force);
  BOOST_TEST((stage.tip().contact == TipContact::sliding));
  BOOST_TEST((stage.tip().start == SlipStart::moving));
  BOOST_TEST(stage.tip().force_sign == 1);
  BOOST_TEST(stage.said(TipEvent::force_positive));
  stage.fire(TipGuard::force);
  BOOST_TEST(stage.said(TipEvent::force_negative));
}

BOOST_AUTO_TEST_CASE(a_sticking_tip_sticks_on_through_a_zero_of_its_force) {
  Stage stage(rod_at(0, 0.5));
  stage.start();
  stage.fire(TipGuard::force);
  BOOST_TEST((stage.tip().contact == TipContact::sticking));
  BOOST_TEST(stage.said(TipEvent::force_positive));
}

BOOST_AUTO_TEST_CASE(slip_that_ends_sticks_or_turns_round) {
  Stage held(rod_at(0.7, 2.0)), turned(rod_at(0.7, 0.1));
  for (auto* stage : {&held, &turned}) {
    stage->tip() = {.contact = TipContact::sliding, .direction = {0, 0, 1}};
    stage->put_gap(-1);
    stage->fire(TipGuard::slip);
  }
  BOOST_TEST((held.tip().contact == TipContact::sticking));
  BOOST_TEST(held.said(TipEvent::stick));
  BOOST_TEST((turned.tip().contact == TipContact::sliding));
  BOOST_TEST((turned.tip().start == SlipStart::turning));
  BOOST_TEST(!turned.tip().at_touch);
  // It slips the way it is free to accelerate.
  const MicrobodyField<double> field(turned.system.mechanics(), turned.x);
  const auto acceleration = field.slip_acceleration(field.forces(turned.mode), 0);
  BOOST_TEST(dot(acceleration, turned.tip().direction) > 0);
}

BOOST_AUTO_TEST_CASE(at_the_edge_of_the_cone_slip_starts_against_the_friction_that_held) {
  Stage stage(rod_at(0.7, 2.0));
  stage.tip().contact = TipContact::sticking;
  stage.put_gap(-1);
  const auto held = stage.system.mechanics().forces(stage.x, stage.mode).friction[0];
  stage.fire(TipGuard::cone);
  BOOST_TEST((stage.tip().contact == TipContact::sliding));
  BOOST_TEST((stage.tip().start == SlipStart::breaking));
  BOOST_TEST(std::abs(dot(stage.tip().direction, held) + norm(held)) < 1e-12 * norm(held));
  BOOST_TEST(stage.said(TipEvent::slip));
}

BOOST_AUTO_TEST_CASE(a_tip_that_turns_back_is_captured_and_ends_the_run_unless_told_to_go_on) {
  auto body = rod_at(0.7, 0.1);
  Stage stage(body);
  stage.start();
  stage.put_gap(-1);
  stage.fire(TipGuard::turn_back);
  BOOST_TEST(stage.said(TipEvent::capture));
  BOOST_TEST(stage.system.is_over(stage.mode, stage.x, true));
  BOOST_TEST((stage.system.ending(stage.mode) == hybrid::Ending::captured));
  body.after_capture = AfterCapture::go_on;
  Stage going(body);
  going.start();
  going.put_gap(-1);
  going.fire(TipGuard::turn_back);
  BOOST_TEST(!going.system.is_over(going.mode, going.x, true));
}

BOOST_AUTO_TEST_CASE(sticking_friction_keeps_the_slip_constant) {
  auto body = rod_at(0.7, 0.5);
  body.spin = {1e5, 2e5, -3e5};
  Stage stage(body);
  stage.tip().contact = TipContact::sticking;
  stage.put_gap(-1);
  const MicrobodyField<double> field(stage.system.mechanics(), stage.x);
  const auto forces = field.forces(stage.mode);
  BOOST_TEST(norm(field.slip_acceleration(forces, 0)) < 1e-12 * norm(forces.friction[0]));
  BOOST_TEST(!forces.redundant);
}

BOOST_AUTO_TEST_CASE(two_tips_of_a_lying_rod_that_stick_share_friction_by_least_norm) {
  auto body = rod_at(std::numbers::pi / 2, 0.5);
  body.impacts = 2;
  Stage stage(body);
  for (Index i = 0; i < 2; ++i) {
    stage.mode.tip[i].contact = TipContact::sticking;
    stage.x[stage.system.layout().place.gap[i]] = -1;
  }
  stage.put_velocity({-1, 0, 0});
  const MicrobodyField<double> field(stage.system.mechanics(), stage.x);
  const auto forces = field.forces(stage.mode);
  BOOST_TEST(forces.redundant);
  // By symmetry each holds the same, and nothing slips.
  BOOST_TEST(norm(forces.friction[0] - forces.friction[1]) < 1e-9);
  for (Index i = 0; i < 2; ++i) BOOST_TEST(norm(field.slip_acceleration(forces, i)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(the_jacobian_agrees_with_differences) {
  const auto tip = [](TipContact contact, SlipStart start) {
    return TipMode{.contact = contact, .start = start, .direction = {0, 0.6, 0.8}};
  };
  const auto clear = tip(TipContact::clear, SlipStart::moving),
             stuck = tip(TipContact::sticking, SlipStart::moving),
             slides = tip(TipContact::sliding, SlipStart::moving),
             turns = tip(TipContact::sliding, SlipStart::turning);
  for (const auto lever : {Lever::radius, Lever::indented})
    for (const auto& tips : {std::array{slides, clear}, std::array{turns, clear}, std::array{stuck, clear},
                             std::array{slides, stuck}, std::array{stuck, stuck}}) {
      auto body = rod_at(0.7, 0.4);
      body.lever = lever;
      body.impacts = 2;
      Stage stage(body);
      stage.mode.tip = tips;
      const auto& place = stage.system.layout().place;
      for (const Index i : {0, 1}) stage.x[place.gap[i]] = -0.3 - 0.2 * static_cast<double>(i);
      put(stage.x, place.attitude, normalized(Quaternion{0.7, 0.4, -0.5, 0.3}));
      stage.put_velocity({0.2, -0.4, 0.3});
      put(stage.x, place.momentum, Vector3{0.3, -0.2, 0.5});
      const auto& mechanics = stage.system.mechanics();
      const auto n = stage.x.size();
      std::vector<double> values(mechanics.pattern().size()), full(n * n, 0.0), up(n), down(n);
      mechanics.jacobian(stage.x, stage.mode, values);
      for (std::size_t e = 0; e < values.size(); ++e) {
        const auto [row, column] = mechanics.pattern()[e];
        full[static_cast<std::size_t>(row) * n + static_cast<std::size_t>(column)] += values[e];
      }
      for (std::size_t j = 0; j < n; ++j) {
        auto x = stage.x;
        x[j] += 1e-5, mechanics.derivative(x, stage.mode, up);
        x[j] -= 2e-5, mechanics.derivative(x, stage.mode, down);
        for (std::size_t i = 0; i < n; ++i) {
          const double slope = (up[i] - down[i]) / 2e-5;
          BOOST_TEST(std::abs(full[i * n + j] - slope) < 1e-7 * (1 + std::abs(slope)),
                     "row " << i << " column " << j << ": " << full[i * n + j] << " against " << slope);
        }
      }
    }
}
