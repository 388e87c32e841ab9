#define BOOST_TEST_MODULE impact drives
// Walls that move, and forces that act, as a function of time says.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>

#include "mariotte/contact/stated_law.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/impact/network/network_solver.hpp"
#include "mariotte/model/chain/chain_system.hpp"
#include "support/driven_rows.hpp"
#include "support/naive_chain.hpp"

using namespace mariotte;
using namespace mariotte::test;
using impact::simulate;
using model::Driven;
using std::numbers::pi;

namespace {

/// A wall that moves at this speed until a time, and stops at once.
model::Drive stopping(double speed, double time) {
  return drive(0, Driven::position, model::straight_lines({{0, 0}, {time, speed * time}}));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_force_pulse_on_a_free_ball_is_its_impulse) {
  const double force = 3, duration = 0.7, impulse = 2 / pi * force * duration;
  for (const auto kind : {flow::Kind::taylor, flow::Kind::cvode_adams, flow::Kind::cvode_bdf_klu}) {
    model::Chain chain{.mass = {2, 1}, .law = {contact::Hertz(1)}, .gap = {10}, .velocity = {0, 0}};
    chain.drive = {drive(0, Driven::force, model::half_sine(force, duration))};
    auto options = until(2);
    options.flow = kind;
    const auto impact = simulate(chain, options);
    BOOST_TEST((impact.ending == hybrid::Ending::time_limit), impact.message);
    BOOST_TEST(impact.velocity[0] == impulse / 2, boost::test_tools::tolerance(1e-10));
    BOOST_TEST(impact.energy.work == impulse * impulse / 4, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(impact.contacts[0].impulse == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_ball_on_a_vibrating_wall_is_a_driven_oscillator) {
  const double k = 4, speed = 0.5, frequency = 3, own = std::sqrt(k);  // the mass is 1
  for (const double time : {0.3, 0.8, 1.2}) {                          // δ > 0 up to 2π/(ω + ω₀)
    const auto chain =
        row_behind_wall({contact::Linear(k)}, drive(0, Driven::velocity, model::sine(speed, frequency, 0)));
    const auto impact = simulate(chain, until(time));
    const double factor = speed * frequency / (own * own - frequency * frequency);
    const double depth = factor * (std::cos(frequency * time) - std::cos(own * time));
    const double rate = factor * (own * std::sin(own * time) - frequency * std::sin(frequency * time));
    const double wall = speed * std::sin(frequency * time);
    BOOST_TEST(impact.velocity[0] == wall, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(impact.velocity[1] == wall - rate, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(-impact.gap[0] == depth, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(impact.energy.work == 0.5 * impact.velocity[1] * impact.velocity[1] + 0.5 * k * depth * depth,
               boost::test_tools::tolerance(1e-9));
    BOOST_TEST(impact.flows.front().name == "taylor");
  }
}

/// (k + iωc)(u_{j−1} − 2u_j + u_{j+1}) = −mω²u_j with u_0 given and u_{n+1} = 0 is solved by sinh q(n+1−j),
/// and cosh q = 1 − mω²/2(k + iωc): q is imaginary in the pass band of an undamped row, and real above it.
BOOST_AUTO_TEST_CASE(a_driven_row_passes_waves_on_below_its_cut_off_and_damps_them_above) {
  using Complex = std::complex<double>;
  constexpr int balls = 5;
  const double k = 1, c = 0.3, amplitude = 1e-3, time = 700;
  for (const double frequency : {0.7, 1.5, 2.5, 4.0}) {
    auto chain = row_behind_wall(std::vector<contact::Law>(balls + 1, contact::PowerLaw{k, c, 1}),
                                 drive(0, Driven::position, model::sine(amplitude, frequency, 0)));
    chain.gap.assign(balls + 1, -0.1);
    chain.precompressed = true;
    chain.mass.back() = infinity;
    const auto impact = simulate(chain, until(time, 1e-11));
    const Complex spring(k, frequency * c);
    const Complex q = std::acosh(1.0 - frequency * frequency / (2.0 * spring));
    double last = infinity;
    for (int j = 1; j <= balls; ++j) {
      const Complex transfer = std::sinh(q * double(balls + 1 - j)) / std::sinh(q * double(balls + 1));
      const Complex turn = std::polar(amplitude * frequency, frequency * time);
      BOOST_TEST(std::abs(impact.velocity[j] - (transfer * turn).real()) < 1e-8 * amplitude * frequency,
                 "frequency " << frequency << ", ball " << j);
      if (frequency > 2) BOOST_TEST(std::abs(transfer) < 0.75 * last);
      last = std::abs(transfer);
    }
    BOOST_TEST(std::abs(impact.energy.residual) < 1e-8 * amplitude * amplitude);
  }
}

BOOST_AUTO_TEST_CASE(a_wall_that_stops_at_once_is_met_without_an_error) {
  const double speed = 0.8, time = 0.9, k = 1.7, own = std::sqrt(k);
  const double depth = speed / own * std::sin(own * time), rate = speed * std::cos(own * time);
  const double ball = speed - rate;
  const auto run = [&](const contact::Law& law) {
    const auto impact = simulate(row_behind_wall({law}, stopping(speed, time)), until(20));
    BOOST_TEST(impact.velocity[0] == 0);
    BOOST_TEST(std::abs(impact.energy.residual) < 1e-9);
    return impact;
  };
  BOOST_TEST(run(contact::Linear(k)).velocity[1] == std::sqrt(ball * ball + k * depth * depth),
             boost::test_tools::tolerance(1e-9));
  // It turns without a guard that has crossed: unloading is along the steeper line.
  const double steep = 2.9, left = depth * k / steep;
  const auto plastic = run(contact::state(contact::WaltonBraun(k, steep)));
  BOOST_TEST(plastic.velocity[1] == std::sqrt(ball * ball + steep * left * left),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(plastic.contacts[0].permanent_indentation == depth - left, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_damped_contact_goes_slack_where_its_wall_stops_at_once) {
  const double speed = 1, time = 0.5, k = 1;
  const auto strong = row_behind_wall({contact::PowerLaw{k, 8.0, 1}}, stopping(speed, time));
  const auto parted = simulate(strong, until(0.6));
  const double root = std::sqrt(16.0 - k), slow = -4 + root, fast = -4 - root;
  const double last = speed * (slow * std::exp(slow * time) - fast * std::exp(fast * time)) / (2 * root);
  // δ̇ jumps from `last` to −(V − last), and the load with it below zero: the ball flies on as it is.
  BOOST_TEST(parted.velocity[1] == speed - last, boost::test_tools::tolerance(1e-9));
}

namespace {

/// A drive and what it is, written once more.
struct Pushed {
  model::Drive drive;
  std::function<double(double)> acceleration;  ///< of its ball, by the drive alone
};

Pushed random_drive(std::mt19937_64& random, Index ball, double mass) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const double a = uniform(0.3, 1), w = uniform(0.5, 5), phi = uniform(0, 6), end = uniform(0.5, 2);
  switch (std::uniform_int_distribution(0, 4)(random)) {
    case 0:
      return {drive(ball, Driven::velocity, model::sine(a, w, phi)),
              [=](double t) { return a * w * std::cos(w * t + phi); }};
    case 1:
      return {drive(ball, Driven::position, model::sine(a, w, phi)),
              [=](double t) { return -a * w * w * std::sin(w * t + phi); }};
    case 2:
      return {drive(ball, Driven::velocity, model::straight_lines({{0, 0}, {end, a}, {2 * end, 0}})),
              [=](double t) { return t < end       ? a / end
                                     : t < 2 * end ? -a / end
                                                   : 0; }};
    case 3:
      return {drive(ball, Driven::force, model::sine(a, w, phi)),
              [=](double t) { return a * std::sin(w * t + phi) / mass; }};
    default:
      return {drive(ball, Driven::force, model::half_sine(a, end)),
              [=](double t) { return t < end ? a * std::sin(pi * t / end) / mass : 0; }};
  }
}

contact::Law random_law(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  switch (std::uniform_int_distribution(0, 3)(random)) {
    case 0:
      return contact::Linear(uniform(1, 10));
    case 1:
      return contact::Hertz(uniform(1, 10));
    case 2:
      return contact::PowerLaw{uniform(1, 10), uniform(0.1, 1), 1.5};
    default:
      return contact::state(contact::WaltonBraun(uniform(1, 5), uniform(5, 10)));
  }
}

struct Scene {
  model::Chain chain;
  NaiveContacts naive;
};

/// A few balls of which the first is driven, maybe on a wall and under gravity.
Scene random_scene(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  model::Chain chain;
  const int balls = std::uniform_int_distribution(2, 5)(random);
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(uniform(0.5, 2));
    chain.velocity.push_back(uniform(-0.3, 0.3));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(uniform(0.05, 0.5));
    chain.law.push_back(random_law(random));
  }
  const auto pushed = random_drive(random, 0, chain.mass[0]);
  chain.drive = {pushed.drive};
  if (pushed.drive.quantity != Driven::force) {
    chain.mass[0] = infinity;
    chain.velocity[0] = start_velocity(pushed.drive);
    if (uniform(0, 1) < 0.5) chain.gravity = uniform(0, 0.5);
  }
  auto naive = naive_contacts(chain);
  naive.given = [pushed](std::size_t i, double t) { return i == 0 ? pushed.acceleration(t) : 0; };
  return {std::move(chain), std::move(naive)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_driven_rows_agree_with_a_naive_simulator) {
  std::mt19937_64 random(20261123);
  int contacts = 0;
  for (int n = 0; n < 60; ++n) {
    const auto [chain, naive] = random_scene(random);
    const double end = 6;
    const auto impact = simulate(chain, until(end));
    BOOST_TEST((impact.ending == hybrid::Ending::time_limit), "scene " << n << ": " << impact.message);
    for (const auto& contact : impact.contacts) contacts += !contact.periods.empty();
    const auto rough = run_naive(naive, {.end = end, .speed = model::reference_speed(chain)});
    BOOST_TEST_REQUIRE(rough.complete);
    for (std::size_t i = 0; i < chain.mass.size(); ++i)
      BOOST_TEST(
          std::abs(impact.velocity[i] - rough.velocity[i]) < 3e-5,
          "scene " << n << ", ball " << i << ": " << impact.velocity[i] << " and " << rough.velocity[i]);
    BOOST_TEST(std::abs(impact.energy.residual) < 1e-8, "scene " << n);
    BOOST_TEST(std::abs(impact.momentum.residual) < 1e-8, "scene " << n);
    const auto brief = impact::ChainSolver().solve(chain, until(end));
    BOOST_TEST(std::abs(brief.velocity[0] - impact.velocity[0]) < 1e-9);
    auto by_adams = until(end);
    by_adams.flow = flow::Kind::cvode_adams;
    const auto other = simulate(chain, by_adams);
    for (std::size_t i = 0; i < chain.mass.size(); ++i)
      BOOST_TEST(std::abs(other.velocity[i] - impact.velocity[i]) < 1e-8, "scene " << n << ", ball " << i);
    BOOST_TEST(std::abs(other.energy.work - impact.energy.work) < 1e-8, "scene " << n);
    if (chain.gravity != 0) continue;
    const auto network = simulate(model::as_network(chain), until(end));
    BOOST_TEST((network.ending == hybrid::Ending::time_limit), "scene " << n << ": " << network.message);
    for (std::size_t i = 0; i < chain.mass.size(); ++i)
      BOOST_TEST(std::abs(network.velocity[i] - impact.velocity[i]) < 1e-8, "scene " << n);
    BOOST_TEST(std::abs(network.energy.work - impact.energy.work) < 1e-8, "scene " << n);
    BOOST_TEST(network.momentum_residual < 1e-8);
  }
  BOOST_TEST(contacts > 60);
}

BOOST_AUTO_TEST_CASE(what_touches_at_rest_is_watched_as_soon_as_it_is_pressed) {
  const auto run = [](const contact::Law& law, flow::Kind kind, double accuracy) {
    model::Chain chain{.mass = {infinity, 1}, .law = {law}, .gap = {0}, .velocity = {0, 0}};
    chain.drive = {drive(1, Driven::force, model::straight_lines({{0, -0.01}, {0.3, 0.04}, {1, 0.04}}))};
    auto options = until(2, accuracy);
    options.flow = kind;
    return simulate(chain, options);
  };
  for (const contact::Law& law :
       {contact::Law(contact::Linear(4)), contact::Law(contact::PowerLaw{4, 0.3, 1}),
        contact::state(contact::WaltonBraun(4, 9)), contact::Law(contact::Hertz(4))}) {
    const auto right = run(law, flow::Kind::cvode_adams, 1e-12);
    for (const double accuracy : {1e-6, 1e-10, 1e-13}) {
      const auto found = run(law, flow::Kind::taylor, accuracy);
      BOOST_TEST(found.velocity[1] == right.velocity[1],
                 boost::test_tools::tolerance(std::max(accuracy, 1e-10)));
      BOOST_TEST(found.contacts[0].peak_force == right.contacts[0].peak_force,
                 boost::test_tools::tolerance(std::max(10 * accuracy, 1e-9)));
      BOOST_TEST(found.events.size() == right.events.size());
    }
  }
}

// A ball that a wall draws away from another slowly parts from it at once.
BOOST_AUTO_TEST_CASE(what_is_drawn_apart_is_open) {
  model::Chain chain{.mass = {infinity, 1}, .law = {contact::Hertz(1)}, .gap = {0}, .velocity = {0, 0}};
  chain.drive = {drive(1, Driven::force, model::half_sine(1e-3, 20))};
  const auto impact = simulate(chain, until(10));
  BOOST_TEST_REQUIRE(impact.contacts[0].periods.size() == 1U);
  BOOST_TEST(impact.contacts[0].periods[0].end.value_or(infinity) < 0.1);
  BOOST_TEST(impact.contacts[0].peak_force == 0);
}

BOOST_AUTO_TEST_CASE(what_gravity_draws_apart_never_closes_beside_a_drive) {
  model::Chain chain{.mass = {infinity, 1, infinity},
                     .law = {contact::Hertz(1), contact::Hertz(1)},
                     .gap = {10, 0},
                     .velocity = {0, 0, 0},
                     .gravity = 0.25};
  chain.drive = {drive(0, Driven::velocity, model::sine(0.1, 1, 0))};
  for (const double accuracy : {1e-6, 1e-12}) {
    const auto impact = simulate(chain, {.accuracy = accuracy, .max_time = 2});
    BOOST_TEST(impact.events.empty());
    BOOST_TEST(impact.contacts[1].periods.empty());
    BOOST_TEST(std::abs(impact.velocity[1] + 0.5) < 1e-12);
  }
}

// As of other chains: the last sample is that of the ending.
BOOST_AUTO_TEST_CASE(the_last_sample_of_a_driven_row_is_that_of_its_end) {
  const auto row = row_behind_wall({contact::Hertz(1)}, drive(0, Driven::velocity, model::sine(0.1, 1, 0)));
  std::vector<impact::Sample> samples;
  const auto take = [&](const impact::Sample& sample) {
    samples.push_back(sample);
    return 0.3;
  };
  const auto found =
      simulate(row, until(1), {.samplings = {{.velocities = {1}, .contacts = {}, .take = take}}});
  BOOST_TEST_REQUIRE(samples.size() == 5u);
  BOOST_TEST(samples.back().time == 1);
  BOOST_TEST(samples.back().velocity[0] == found.velocity[1]);
}

// The velocity of the wall is one or the other, by rounding; those of the balls are not.
BOOST_AUTO_TEST_CASE(a_run_that_ends_as_its_wall_stops_is_as_accurate_as_any) {
  const auto chain_until = [](double time) {
    model::Chain chain{.mass = {infinity, 0.006, 0.03},
                       .law = {contact::Linear(1e5), contact::Linear(1e6)},
                       .gap = {1e-4, 2e-4},
                       .velocity = {1e-4 / time, 0, 0},
                       .gravity = 9.81};
    chain.drive = {stopping(1e-4 / time, time)};
    return chain;
  };
  for (const double time : {17e-3, std::sqrt(3) * 1e-2, 0.0191, 0.0203}) {
    const auto chain = chain_until(time);
    const auto ends = simulate(chain, until(time)), goes_on = simulate(chain, until(time * (1 + 1e-9)));
    for (const int ball : {1, 2}) BOOST_TEST(std::abs(ends.velocity[ball] - goes_on.velocity[ball]) < 1e-9);
    BOOST_TEST(ends.estimated_accuracy.value_or(0) < 1e-10);
    BOOST_TEST(impact::estimate_accuracy(chain, until(time), ends) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const auto sine = model::sine(1, 1, 0);
  const auto good = row_behind_wall({contact::Hertz(1)}, drive(0, Driven::velocity, sine));
  BOOST_CHECK_THROW(simulate(good, {}), InvalidParameter);  // no end
  BOOST_CHECK_THROW(simulate(model::as_network(good), {}), InvalidParameter);
  auto force = good;
  force.drive[0].quantity = Driven::force;
  BOOST_CHECK_THROW(simulate(force, until(1)), InvalidParameter);
  auto ball = good;
  ball.mass[0] = 1;
  BOOST_CHECK_THROW(simulate(ball, until(1)), InvalidParameter);
  auto twice = good;
  twice.drive.push_back(good.drive[0]);
  BOOST_CHECK_THROW(simulate(twice, until(1)), InvalidParameter);
  auto other = good;
  other.velocity[0] = 1;
  BOOST_CHECK_THROW(simulate(other, until(1)), InvalidParameter);
  BOOST_CHECK_THROW(model::half_sine(1, 0), InvalidParameter);
  BOOST_CHECK_THROW(model::smooth_curve({{0, 1}, {0, 2}}), InvalidParameter);
  BOOST_CHECK_THROW(model::straight_lines({{1, 1}, {2, 2}}), InvalidParameter);
}

BOOST_AUTO_TEST_CASE(the_jacobian_of_a_driven_phase_is_that_of_its_field) {
  const auto damped = contact::PowerLaw{2, 0.7, 1.5};
  auto chain = row_behind_wall({damped, damped}, drive(0, Driven::velocity, model::sine(0.6, 1.3, 0.2)));
  chain.gap.assign(2, -0.3);
  chain.precompressed = true;
  chain.drive.push_back(drive(2, Driven::force, model::sine(0.8, 0.9, 0.5)));
  model::ChainSystem system;
  system.reset(chain, 1e-10, true);
  std::vector<double> x;
  initial_state(system.chain(), system.layout(), x);
  x[system.layout().clock] = 0.4;
  x[system.layout().velocity[2]] = -0.1;
  model::ChainSystem::Mode mode;
  std::vector<model::ContactChange> changes;
  system.mode_at(x, mode, changes);
  auto& problem = system.problem(mode);
  const auto pattern = problem.pattern();
  const auto n = x.size();
  std::vector<double> entries(pattern.size()), matrix(n * n), low(n), high(n);
  problem.jacobian(x, entries);
  for (std::size_t e = 0; e < pattern.size(); ++e)
    matrix[n * pattern[e].row + pattern[e].column] += entries[e];
  for (std::size_t c = 0; c < n; ++c) {
    const double h = 1e-5, at = x[c];
    x[c] = at - h, problem.derivative(x, low);
    x[c] = at + h, problem.derivative(x, high);
    x[c] = at;
    for (std::size_t r = 0; r < n; ++r)
      BOOST_TEST(std::abs(matrix[n * r + c] - (high[r] - low[r]) / (2 * h)) < 1e-7,
                 problem.component(r) << " by " << problem.component(c));
  }
}
