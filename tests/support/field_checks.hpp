// What is asked of every field: its series, Jacobian and slopes against its right-hand side, in extended
// precision.
#pragma once
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#ifndef MARIOTTE_SERIES_CALLS
#define MARIOTTE_SERIES_CALLS
#endif
#include "mariotte/series/jacobian.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::test {

using series::Dual, series::Parameters, series::Series, series::States, series::rows_of, series::states_of;
using Exact = long double;
inline constexpr int order = 20;

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

/// Kept out of the templates, which it would make slow to compile.
inline void expect_small(Exact error, Exact bound, const char* what, int row) {
  BOOST_TEST(std::abs(error) < bound, what << " of row " << row << " is wrong by " << error);
}
inline void expect_reach(Exact end) {
  BOOST_TEST(end > 1e-3);
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
  expect_reach(end);
  for (const double part : {0.0, 0.3, 1.0}) {
    States<Field, Exact> x;
    for (int i = 0; i < Field::states; ++i) x[i] = evaluate(series[i], part * end).first;
    const auto expected = Field::rates(x, as<Exact>(c.parameters));
    Exact size = 1;
    for (const auto& value : expected) size = std::max(size, std::abs(value));
    for (int i = 0; i < Field::rows; ++i) {
      const auto [value, slope] = evaluate(series[i], part * end);
      const Exact error = (i < Field::states ? slope : value) - expected[i];
      expect_small(error, 1e-13 * size, "series", i);
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
      expect_small(jacobian[i][j] - expected[i], 1e-11 * (1 + std::abs(expected[i])), "Jacobian", i);
  }
}

/// Slopes of the series, along a direction in which everything changes, solve the equation that the field has
/// for slopes.
template <class Field>
void check_slopes(const Case<Field, double>& c) {
  static Series<Field, order, Dual<double, 1>> series;
  auto start = as<Dual<double, 1>>(c.start);
  auto parameters = as<Dual<double, 1>>(c.parameters);
  for (auto& value : start) value.slope[0] = 0.5 * value.value;
  for (int i = 0; i < Field::parameters; ++i)
    if (i != c.exponent) parameters[i].slope[0] = -0.25 * c.parameters[i];
  series.expand(start, parameters, order);
  std::array<std::array<double, order + 1>, rows_of<Field>> values, slopes;
  for (int i = 0; i < Field::rows; ++i)
    for (int k = 0; k <= order; ++k) {
      values[i][k] = series[i][k].value;
      slopes[i][k] = series[i][k].slope[0];
    }
  const Exact end = std::min(reach<Field>(values), reach<Field>(slopes));
  expect_reach(end);
  const auto expected = difference(
      [&](Exact step) {
        States<Field, Exact> x;
        Parameters<Field, Exact> p = as<Exact>(c.parameters);
        for (int i = 0; i < Field::states; ++i)
          x[i] = evaluate(values[i], end).first + step * evaluate(slopes[i], end).first;
        for (int i = 0; i < Field::parameters; ++i) p[i] += step * parameters[i].slope[0];
        return Field::rates(x, p);
      },
      1e-4L);
  Exact size = 1;
  for (const auto& value : expected) size = std::max(size, std::abs(value));
  for (int i = 0; i < Field::rows; ++i) {
    const auto [value, slope] = evaluate(slopes[i], end);
    const Exact error = (i < Field::states ? slope : value) - expected[i];
    expect_small(error, 1e-11 * size, "slope", i);
  }
}

/// Everything that is derived from a field agrees with the field, at random places about the given one.
template <class Field>
void check(const Case<Field, double>& about) {
  for (const auto& c : cases<Field>(about)) {
    check_residual<Field>(c);
    check_jacobian<Field>(c);
    check_slopes<Field>(c);
  }
}

}  // namespace mariotte::test
