#include "mariotte/flow/pair/width_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "mariotte/flow/roots/polynomial.hpp"

namespace mariotte::flow {
namespace {

/// Gauss's rule with n points on [−1, 1].
template <int n>
struct GaussRule {
  std::array<double, n> place, weight;
  GaussRule() {
    for (int i = 0; i < n; ++i) {
      double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 0;
      for (int k = 0; k < 8; ++k) {
        double before = 1, now = x;
        for (int j = 2; j <= n; ++j)
          before = std::exchange(now, ((2 * j - 1) * x * now - (j - 1) * before) / j);
        slope = n * (x * now - before) / (x * x - 1);
        x -= now / slope;
      }
      place[i] = x;
      weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
  template <class Function>
  double operator()(Function&& f, double from, double to) const {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += weight[i] * f(0.5 * (from + to + (to - from) * place[i]));
    return 0.5 * (to - from) * sum;
  }
};

/// By two rules that agree, but for rounding, on halves where they do not; not a number if they never do, as
/// where a motion begins at a turn in its well.
template <class Function>
double integral(Function&& f, double from, double to, double tolerance, int halvings = 12) {
  static const GaussRule<16> coarse;
  static const GaussRule<24> fine;
  const double sum = fine(f, from, to);
  if (std::abs(sum - coarse(f, from, to)) <= std::max(tolerance, 16 * epsilon * std::abs(sum))) return sum;
  if (halvings == 0) return std::numeric_limits<double>::quiet_NaN();
  const double middle = 0.5 * (from + to);
  return integral(f, from, middle, 0.5 * tolerance, halvings - 1) +
         integral(f, middle, to, 0.5 * tolerance, halvings - 1);
}

/// Share of u* within which the rate tells better than u* − u how far the turn is.
constexpr double near = 1e-4;

}  // namespace

WidthMotion::WidthMotion(const WidthBranch& branch, double reduced_mass, const Indentation& start)
    : curve_(branch.curve) {
  const double begin = curve_.root(start.value);
  std::array<double, degree + 1> square{};  // P: of the kinetic energy over m*/2
  for (int i = 0; i < 7; ++i) {
    const double push = 2 / reduced_mass * branch.push[i];
    square[i + 4] -= push * 4 / curve_.radius / (i + 4);
    square[i + 1] += push * curve_.s / (i + 1);
  }
  square[0] = start.rate * start.rate - horner(square, begin);
  find_top(square, begin);
  double above = 0;  // P/(u* − u) by Horner's scheme
  for (int k = degree; k > 0; --k) quotient_[k - 1] = -(above = above * top_ + square[k]);
  const double below = std::max(0.0, top_ - begin);
  y_start_ = std::copysign(std::sqrt(below), -start.rate);
  if (below < near * top_) y_start_ = -start.rate / speed_over_y(y_start_);  // the difference is rounding
  y_end_ = std::sqrt(top_ - curve_.last());
}

/// From beyond, where P is negative and falls, by Newton's method. At the start itself P may be rounding.
void WidthMotion::find_top(const std::array<double, degree + 1>& square, double begin) {
  double u = 1.25 * begin;
  for (int i = 0; i < 200 && !(horner(square, u) < 0); ++i) u *= 1.25;
  for (int i = 0; i < 60; ++i) {
    double value = 0, slope = 0;
    for (int k = degree; k >= 0; --k) {
      slope = slope * u + value;
      value = value * u + square[k];
    }
    const double step = value / slope;
    u -= step;
    if (!(step > 2 * epsilon * u)) break;
  }
  top_ = std::max(u, begin);
}

double WidthMotion::speed_over_y(double y) const {
  return std::sqrt(std::max(0.0, horner(quotient_, width(y))));
}

double WidthMotion::time(double from, double to) const {
  const double tolerance = 1e-13 * pace(0) * (y_end_ - y_start_);
  return integral([this](double y) { return pace(y); }, from, to, tolerance);
}

Indentation WidthMotion::there(double y) const {
  return {curve_.indentation(width(y)), -y * speed_over_y(y)};
}

Reached WidthMotion::opening() const {
  const bool lets_go = horner(quotient_, curve_.last()) > 0;
  return {lets_go ? time(y_start_, y_end_) : infinity, there(y_end_)};
}

Reached WidthMotion::reach(double depth) const {
  const double u = curve_.root(depth);
  if (y_start_ >= 0 || !(u < top_)) return {infinity, {}};
  const double y = -std::sqrt(top_ - u);
  return {time(y_start_, std::max(y, y_start_)), {depth, there(y).rate}};
}

/// The speed is of the size of rounding, and so is y.
Reached WidthMotion::recede(double speed) const {
  double y = speed / speed_over_y(0);
  for (int i = 0; i < 3; ++i) y = speed / speed_over_y(y);
  if (!(y < y_end_) || !(y > y_start_)) return {infinity, {}};
  return {time(y_start_, y), there(y)};
}

Indentation WidthMotion::at(double elapsed) const {
  double low = y_start_, high = y_end_, y = low, now = 0;
  for (int i = 0; i < 60; ++i) {
    double next = y + (elapsed - now) / pace(y);
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    if (std::abs(next - y) <= 4 * epsilon * y_end_) break;
    now += time(y, next);
    y = next;
    (now < elapsed ? low : high) = y;
  }
  return there(y);
}

}  // namespace mariotte::flow
