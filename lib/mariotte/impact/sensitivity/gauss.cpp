#include "mariotte/impact/sensitivity/gauss.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace mariotte::impact {
namespace {

/// P_k and its slope at x.
std::pair<double, double> legendre(int k, double x) {
  double before = 1, now = x;
  if (k == 0) return {1, 0};
  for (int i = 2; i <= k; ++i) {
    const double next = ((2 * i - 1) * x * now - (i - 1) * before) / i;
    before = now;
    now = next;
  }
  return {now, k * (x * now - before) / (x * x - 1)};
}

/// The i-th root of P_stages in [−1, 1].
double root(int i) {
  double x = -std::cos(std::numbers::pi * (i + 0.75) / (stages + 0.5));
  for (int n = 0; n < 50; ++n) {
    const auto [p, slope] = legendre(stages, x);
    x -= p / slope;
  }
  return x;
}

/// ∫ P_k from −1 to x, on [0, 1].
double legendre_integral(int k, double x) {
  return k == 0 ? 0.5 * (x + 1) : 0.5 * (legendre(k + 1, x).first - legendre(k - 1, x).first) / (2 * k + 1);
}

/// ∫ P_k ln u on [0, 1].
double legendre_log(int k) {
  return k == 0 ? -1 : (k % 2 == 0 ? -1.0 : 1.0) / (k * (k + 1));
}

}  // namespace

Gauss::Gauss() {
  double x[stages], coefficient[stages][stages];
  for (int i = 0; i < stages; ++i) {
    x[i] = root(i);
    const double slope = legendre(stages, x[i]).second;
    point[i] = 0.5 * (1 + x[i]);
    weight[i] = 1 / ((1 - x[i] * x[i]) * slope * slope);
  }
  // Coefficients of an interpolant are (2k + 1) Σ_i b_i P_k(x_i) f(x_i).
  for (int k = 0; k < stages; ++k)
    for (int i = 0; i < stages; ++i) coefficient[k][i] = (2 * k + 1) * weight[i] * legendre(k, x[i]).first;
  for (int i = 0; i < stages; ++i)
    for (int j = 0; j < stages; ++j) {
      integral[i][j] = 0;
      for (int k = 0; k < stages; ++k) integral[i][j] += legendre_integral(k, x[i]) * coefficient[k][j];
    }
  for (int i = 0; i < stages; ++i) {
    log_rest[i] = -weight[i] * std::log(point[i]);
    for (int k = 0; k < stages; ++k) log_rest[i] += legendre_log(k) * coefficient[k][i];
  }
  for (int k = 0; k < tail_length; ++k)
    for (int i = 0; i < stages; ++i) tail[k][i] = coefficient[stages - tail_length + k][i];
}

const Gauss gauss;

double remainder(double before, double last) {
  static_assert(stages == 8);
  const double fall = last < before ? last / before : 1, square = fall * fall;
  return last * square * square;
}

double largest_tail(double accuracy) {
  return 3 * std::sqrt(accuracy);
}

bool is_resolved(const Tail& tail, double accuracy) {
  return tail.last <= largest_tail(accuracy) && tail.rest <= 10 * accuracy;
}

bool is_resolved(double before, double last, double accuracy) {
  return is_resolved({.last = last, .rest = remainder(before, last)}, accuracy);
}

}  // namespace mariotte::impact
