// What is derived from a field agrees with the field; fields that the library does not need.
#define BOOST_TEST_MODULE series of fields
#include <boost/test/unit_test.hpp>

#include "series/fields.hpp"
#include "series/sphere_field.hpp"
#include "support/field_checks.hpp"

using namespace mariotte;
using namespace mariotte::test;
using series::program;

BOOST_AUTO_TEST_CASE(everything_that_is_derived_agrees_with_a_sphere_on_a_plane) {
  check<SphereField>({{0.3, 0.7}, {1.2, 0.1, 0.9}});
}

BOOST_AUTO_TEST_CASE(what_a_field_says_twice_is_computed_once) {
  BOOST_TEST(program<SphereField>.convolutions == 3);
  BOOST_TEST(program<Jkr>.convolutions == 5);
}

BOOST_AUTO_TEST_CASE(it_agrees_with_a_contact_that_necks) {
  check<Jkr>({{0.8, 0.5, 0.1}, {1, 0.3, 1.3, 0.6, 1.1}});
}

BOOST_AUTO_TEST_CASE(it_agrees_with_a_tangential_spring_and_with_sliding) {
  const Case<Mindlin<false>, double> sticks{{0.3, 0.5, 0.4, 0.2, -0.1, 0.01, 0.1, 0.1},
                                            {1, 0.8, 0.1, 0.3, 0.5, 1, 0.7, 0.4, 0.14}};
  check<Mindlin<false>>(sticks);
  check<Mindlin<true>>({sticks.start, sticks.parameters});
}

BOOST_AUTO_TEST_CASE(it_agrees_with_every_operation_at_once) {
  check<Everything>({{0.3, 0.7, 0.4, 0.2}, {1.3, 0.6}, Everything::n});
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
