// Series of a step, of which the beginning is left out.
#define BOOST_TEST_MODULE push_series
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mariotte/flow/push_series.hpp"

using namespace mariotte;

namespace {

constexpr int order = 12;

double value(const flow::PushPolynomial& p, int last, double place) {
  double sum = 0;
  for (int k = last; k >= 0; --k) sum = place * sum + p[k];
  return sum;
}

/// A curved contact whose clock is that of another one; its depth is a square, so that its root is known.
flow::PushSeries motion() {
  flow::PushSeries series{
      .order = order, .end = 0.5, .is_time = false, .pace = {}, .contact = {}, .dozing = {}};
  flow::PushSeries::Contact other{
      .gap = 0, .owns_clock = true, .is_curved = true, .depth = {}, .rate = {}, .root = {}};
  for (int k = 0; k <= order; ++k) {
    series.pace[k] = std::pow(-0.6, k);
    other.rate[k] = std::pow(0.4, k) / (k + 1);
  }
  other.depth[0] = 2, other.root = series.pace;
  flow::PushSeries::Contact own{
      .gap = 1, .is_curved = true, .depth = {1, 0.6, 0.09}, .rate = {3, -1}, .root = {1, 0.3}};
  series.contact = {other, own};
  return series;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_rest_of_a_step_is_the_same_motion) {
  constexpr double begin = 0.2;
  const auto whole = motion();
  auto rest = whole;
  drop(rest, begin);
  BOOST_TEST(std::abs(rest.end - 0.3) < 1e-15);
  const auto expect_same = [&](const flow::PushPolynomial& a, const flow::PushPolynomial& b) {
    for (const double place : {0.0, 0.1, 0.3})
      BOOST_TEST(std::abs(value(a, order, place) - value(b, order, begin + place)) < 1e-14);
  };
  expect_same(rest.pace, whole.pace);
  BOOST_TEST_REQUIRE(rest.contact.size() == whole.contact.size());
  for (std::size_t j = 0; j < rest.contact.size(); ++j) {
    expect_same(rest.contact[j].depth, whole.contact[j].depth);
    expect_same(rest.contact[j].rate, whole.contact[j].rate);
    expect_same(rest.contact[j].root, whole.contact[j].root);
  }
}
