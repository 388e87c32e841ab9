// What is derived from a field agrees with the field: one check for every field.
#define BOOST_TEST_MODULE series of fields
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/series/jacobian.hpp"
#include "mariotte/series/series.hpp"
#include "series/fields.hpp"

using namespace mariotte;
using namespace mariotte::series;

namespace {

using Exact = long double;
constexpr int order = 20;

template <class Field, class T>
struct Case {
  States<Field, T> start;
  Parameters<Field, T> parameters;
  int exponent = -1;  ///< parameter that has no slopes
};

template <class To, class From, std::size_t n>
std::array<To, n> as(const std::array<From, n>& from) {
  std::array<To, n> to;
  for (std::size_t i = 0; i < n; ++i) to[i] = To(from[i]);
  return to;
}

/// A field at random places about the given one.
template <class Field>
std::vector<Case<Field, double>> cases(const Case<Field, double>& about) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> factor(0.8, 1.25);
  std::vector<Case<Field, double>> all(5, about);
  for (auto& one : all) {
    for (auto& value : one.start) value *= factor(random);
    for (auto& value : one.parameters) value *= factor(random);
  }
  return all;
}

/// A polynomial and its slope.
template <class Row>
std::pair<Exact, Exact> evaluate(const Row& row, Exact place) {
  Exact value = 0, slope = 0;
  for (int k = order; k >= 0; --k) {
    slope = slope * place + value;
    value = value * place + row[k];
  }
  return {value, slope};
}

/// Where the last terms of all rows are below rounding.
template <class Field, class Coefficients>
Exact reach(const Coefficients& series) {
  Exact shortest = 1;
  for (int row = 0; row < Field::rows; ++row)
    for (int k = order - 1; k <= order; ++k)
      if (series[row][k] != 0)
        shortest = std::min<Exact>(shortest, std::pow(1e-19L / std::abs(series[row][k]), 1.0L / k));
  return shortest;
}

template <class Field>
void check_residual(const Case<Field, double>& c) {
  static Series<Field, order, double> series;
  series.expand(c.start, c.parameters, order);
  const Exact end = reach<Field>(series);
  BOOST_TEST(end > 1e-3);
  for (const double part : {0.0, 0.3, 1.0}) {
    States<Field, Exact> x;
    for (int i = 0; i < Field::states; ++i) x[i] = evaluate(series[i], part * end).first;
    const auto expected = Field::rates(x, as<Exact>(c.parameters));
    Exact size = 1;
    for (const auto& value : expected) size = std::max(size, std::abs(value));
    for (int i = 0; i < Field::rows; ++i) {
      const auto [value, slope] = evaluate(series[i], part * end);
      const Exact error = (i < Field::states ? slope : value) - expected[i];
      BOOST_TEST(std::abs(error) < 1e-13 * size, "row " << i << " is wrong by " << error);
    }
  }
}

/// Fourth-order difference of f at 0, along its argument.
template <class F>
auto difference(F&& f, Exact step) {
  const auto near_up = f(step), near_down = f(-step), far_up = f(2 * step), far_down = f(-2 * step);
  auto result = near_up;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = (8 * (near_up[i] - near_down[i]) - (far_up[i] - far_down[i])) / (12 * step);
  return result;
}

template <class Field>
void check_jacobian(const Case<Field, double>& c) {
  const auto jacobian = series::jacobian<Field>(c.start, c.parameters);
  for (int j = 0; j < Field::states; ++j) {
    const auto expected = difference(
        [&](Exact step) {
          auto x = as<Exact>(c.start);
          x[j] += step;
          return Field::rates(x, as<Exact>(c.parameters));
        },
        1e-4L);
    for (int i = 0; i < Field::rows; ++i)
      BOOST_TEST(std::abs(jacobian[i][j] - expected[i]) < 1e-11 * (1 + std::abs(expected[i])));
  }
}

/// Slopes of coefficients along a direction in which everything changes.
template <class Field>
void check_slopes(const Case<Field, double>& c) {
  using One = Dual<double, 1>;
  static Series<Field, order, One> with_slopes;
  Case<Field, One> start{as<One>(c.start), as<One>(c.parameters)};
  for (auto& value : start.start) value.slope[0] = 0.5 * value.value;
  for (auto& value : start.parameters) value.slope[0] = -0.25 * value.value;
  if (c.exponent >= 0) start.parameters[c.exponent].slope[0] = 0;
  with_slopes.expand(start.start, start.parameters, order);
  const auto moved = [&](Exact step) {
    static Series<Field, order, Exact> series;
    Case<Field, Exact> there{as<Exact>(c.start), as<Exact>(c.parameters)};
    for (auto& value : there.start) value *= 1 + step / 2;
    for (int i = 0; i < Field::parameters; ++i)
      if (i != c.exponent) there.parameters[i] *= 1 - step / 4;
    series.expand(there.start, there.parameters, order);
    std::vector<Exact> all;
    for (int i = 0; i < Field::rows; ++i)
      for (int k = 0; k <= order; ++k) all.push_back(series[i][k]);
    return all;
  };
  const auto expected = difference(moved, 1e-4L), value = moved(0);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const One& here = with_slopes[int(i) / (order + 1)][i % (order + 1)];
    Exact size = 1e-3;
    for (std::size_t row = i % (order + 1); row < value.size(); row += order + 1)
      size = std::max({size, std::abs(value[row]), std::abs(expected[row])});
    BOOST_TEST(std::abs(here.value - value[i]) < 1e-12 * size);
    BOOST_TEST(std::abs(here.slope[0] - expected[i]) < 1e-9 * size);
  }
}

template <class Field>
void check(const Case<Field, double>& about) {
  for (const auto& c : cases<Field>(about)) {
    check_residual<Field>(c);
    check_jacobian<Field>(c);
    check_slopes<Field>(c);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(everything_that_is_derived_agrees_with_a_sphere_on_a_plane) {
  check<test::Sphere>({{0.3, 0.7, 0.1}, {1.2, 0.1, 0.4, 0.9}});
}

BOOST_AUTO_TEST_CASE(what_a_field_says_twice_is_computed_once) {
  BOOST_TEST(program<test::Sphere>.convolutions == 3);
  BOOST_TEST(program<test::Jkr>.convolutions == 5);
}

BOOST_AUTO_TEST_CASE(it_agrees_with_a_contact_that_necks) {
  check<test::Jkr>({{0.8, 0.5, 0.1}, {1, 0.3, 1.3, 0.6, 1.1}});
}

BOOST_AUTO_TEST_CASE(it_agrees_with_a_tangential_spring_and_with_sliding) {
  const Case<test::Mindlin<false>, double> sticks{{0.3, 0.5, 0.4, 0.2, -0.1, 0.01, 0.1, 0.1},
                                                  {1, 0.8, 0.1, 0.3, 0.5, 1, 0.7, 0.4, 0.14}};
  check<test::Mindlin<false>>(sticks);
  check<test::Mindlin<true>>({sticks.start, sticks.parameters});
}

BOOST_AUTO_TEST_CASE(it_agrees_with_every_operation_at_once) {
  check<test::Everything>({{0.3, 0.7, 0.4, 0.2}, {1.3, 0.6}, test::Everything::n});
}

namespace {

/// Four contacts of a row as one number.
struct Four {
  std::array<double, 4> of{};
  Four() = default;
  explicit Four(double value) { of.fill(value); }
  template <class F>
  static Four each(F&& f) {
    Four result;
    for (int i = 0; i < 4; ++i) result.of[i] = f(i);
    return result;
  }
  friend Four operator+(const Four& a, const Four& b) {
    return each([&](int i) { return a.of[i] + b.of[i]; });
  }
  friend Four operator-(const Four& a, const Four& b) {
    return each([&](int i) { return a.of[i] - b.of[i]; });
  }
  friend Four operator*(const Four& a, const Four& b) {
    return each([&](int i) { return a.of[i] * b.of[i]; });
  }
  friend Four operator*(double a, const Four& b) {
    return each([&](int i) { return a * b.of[i]; });
  }
  friend Four operator/(const Four& a, const Four& b) {
    return each([&](int i) { return a.of[i] / b.of[i]; });
  }
  friend Four sqrt(const Four& a) {
    return each([&](int i) { return std::sqrt(a.of[i]); });
  }
  /// The value of the left neighbour (0) or the right one (1).
  template <int which>
  friend Four map(const Four& a) {
    return each([&](int i) {
      const int from = which == 0 ? i - 1 : i + 1;
      return from < 0 || from > 3 ? 0.0 : a.of[from];
    });
  }
};

struct Neighbours {
  template <int which>
  Four apply(const Four& a) const {
    return map<which>(a);
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(maps_of_a_row_reach_every_order) {
  using test::BallRow;
  static Series<BallRow, order, Four, Neighbours> series;
  Four depth, rate;
  depth.of = {0.1, 0.15, 0.12, 0.2};
  rate.of = {0.3, -0.2, 0.1, 0.4};
  const Parameters<BallRow, Four> parameters{Four(1.1)};
  series.expand({depth, rate}, parameters, order);
  const auto at = [&](int row, int slope, double place) {
    return Four::each([&](int i) {
      std::array<double, order + 1> one;
      for (int k = 0; k <= order; ++k) one[k] = series[row][k].of[i];
      const auto [value, rate_there] = evaluate(one, place);
      return double(slope ? rate_there : value);
    });
  };
  for (const double place : {0.0, 0.01, 0.02}) {
    const auto expected = BallRow::rates(
        std::array<Four, 2>{at(BallRow::depth, 0, place), at(BallRow::rate, 0, place)}, parameters);
    for (int row = 0; row < BallRow::states; ++row)
      for (int i = 0; i < 4; ++i) BOOST_TEST(std::abs(at(row, 1, place).of[i] - expected[row].of[i]) < 1e-13);
  }
}
