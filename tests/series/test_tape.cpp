// Fields that are recorded at run time, and their power series, beside closed forms.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/series/tape_series.hpp"

using namespace mariotte;
using series::Tape;
using series::TapeClock;
using series::TapeOp;
using series::TapeSeries;
using series::TapeState;
using series::Traced;

namespace {

Traced component(Tape& tape, int i, double value) {
  return {tape, tape.put({.op = TapeOp::state, .a = i}), value};
}

double sum(std::span<const double> row, double x) {
  double value = 0;
  for (std::size_t k = row.size(); k-- > 0;) value = value * x + row[k];
  return value;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_operation_stands_on_a_tape_once) {
  Tape tape;
  const auto x = component(tape, 0, 2), y = component(tape, 1, 3);
  const auto one = x * y, two = y * x;
  BOOST_TEST(one.place_on(tape) == two.place_on(tape));
  BOOST_TEST((0.0 * x).is_constant());
  BOOST_TEST((1.0 * x).place_on(tape) == x.place_on(tape));
  BOOST_TEST(sin(x).place_on(tape) + 1 == cos(x).place_on(tape));
  BOOST_TEST((x / y - sqrt(x)).value() == 2.0 / 3 - std::sqrt(2.0));
}

/// x' = x y, y' = −sin(y)/√x, z' = x (an integral), beside small steps of Runge and Kutta.
BOOST_AUTO_TEST_CASE(series_follow_a_field) {
  Tape tape;
  const auto x = component(tape, 0, 1.5), y = component(tape, 1, 0.4);
  const int z = tape.put({.op = TapeOp::state, .a = 2});
  const auto dx = x * y, dy = -(sin(y) / sqrt(x));
  std::vector<TapeState> state{{.place = x.place_on(tape), .rate = dx.place_on(tape)},
                               {.place = y.place_on(tape), .rate = dy.place_on(tape)},
                               {.place = z, .rate = x.place_on(tape)}};
  TapeSeries series;
  series.prepare(tape, state, {}, {});
  const std::vector<double> start{1.5, 0.4, 0};
  series.expand(start, 22, {});
  BOOST_TEST(!state[2].feeds);

  using Vector = std::array<double, 3>;
  const auto field = [](const Vector& v) {
    return Vector{v[0] * v[1], -std::sin(v[1]) / std::sqrt(v[0]), v[0]};
  };
  Vector v{1.5, 0.4, 0};
  constexpr int steps = 2000;
  constexpr double end = 0.3, h = end / steps;
  const auto moved = [&](const Vector& by, double t) {
    return Vector{v[0] + t * by[0], v[1] + t * by[1], v[2] + t * by[2]};
  };
  for (int i = 0; i < steps; ++i) {
    const auto a = field(v), b = field(moved(a, h / 2)), c = field(moved(b, h / 2)), d = field(moved(c, h));
    for (int k = 0; k < 3; ++k) v[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  }
  for (int k = 0; k < 3; ++k)
    BOOST_TEST(sum(series.row(state[k].place), end) == v[k], boost::test_tools::tolerance(1e-12));
}

/// x' = v, v' = −x^{3/2} from x = 0: in the clock of the onset, and on in that of the root, the energy stays.
BOOST_AUTO_TEST_CASE(clocks_pass_the_beginning_and_the_end_of_a_contact) {
  Tape tape;
  const auto x = component(tape, 0, 0), v = component(tape, 1, 1);
  const auto depth = at_onset(x);
  const auto root = sqrt(depth);
  const auto rate = -(depth * root);
  std::vector<TapeState> state{{.place = x.place_on(tape), .rate = v.place_on(tape)},
                               {.place = v.place_on(tape), .rate = rate.place_on(tape)}};
  const std::vector<int> clocks{root.place_on(tape)};
  TapeSeries series;
  series.prepare(tape, state, clocks, {});
  const auto energy = [](double depth_now, double speed) {
    return 0.5 * speed * speed + 0.4 * std::pow(depth_now, 2.5);
  };
  series.expand(std::vector{0.0, 1.0}, 24, {.kind = TapeClock::Kind::onset});
  const double tau = 0.4;
  BOOST_TEST(sum(series.time(), tau) == tau * tau);
  std::vector<double> now{sum(series.row(state[0].place), tau), sum(series.row(state[1].place), tau)};
  BOOST_TEST(energy(now[0], now[1]) == 0.5, boost::test_tools::tolerance(1e-12));

  now[1] = -now[1];  // on its way out, the same time before the end
  series.expand(now, 24, {.kind = TapeClock::Kind::root, .root = clocks[0]});
  double low = 0, high = 3;
  for (int i = 0; i < 60; ++i)
    (sum(series.row(clocks[0]), 0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  BOOST_TEST(sum(series.time(), low) == tau * tau, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(sum(series.row(state[1].place), low) == -1, boost::test_tools::tolerance(1e-10));
}

/// (a τ² + …)/(b τ + …) has a value at τ = 0, and its inverse has none.
BOOST_AUTO_TEST_CASE(what_is_only_looked_at_may_be_a_quotient_of_zeros) {
  Tape tape;
  const auto x = component(tape, 0, 0), y = component(tape, 1, 0);
  const auto fine = (x * y) / sin(x), pole = sin(x) / (x * y);
  std::vector<TapeState> state{{.place = x.place_on(tape), .rate = Traced(1).place_on(tape)},
                               {.place = y.place_on(tape), .rate = Traced(2).place_on(tape)}};
  const std::vector<int> seen{fine.place_on(tape), pole.place_on(tape)};
  TapeSeries series;
  series.prepare(tape, state, {}, seen);
  series.expand(std::vector{0.0, 0.0}, 20, {});
  BOOST_TEST(sum(series.row(seen[0]), 0.5) == 0.5 / std::sin(0.5), boost::test_tools::tolerance(1e-10));
  BOOST_TEST(std::isnan(series.row(seen[1])[0]));
}
