#include "mariotte/flow/push_series.hpp"

#include <cmath>

namespace mariotte::flow {
namespace {

/// Coefficients of the k-th power around another place: C(k, i), to which a power of the place belongs.
struct Binomials {
  double of[most_orders + 1][most_orders + 1] = {};
  constexpr Binomials() {
    for (int k = 0; k <= most_orders; ++k) {
      of[k][0] = 1;
      for (int i = 1; i <= k; ++i) of[k][i] = of[k - 1][i - 1] + of[k - 1][i];
    }
  }
};
constexpr Binomials binomial;

/// Powers of a place, the highest first.
PushPolynomial powers(double place) {
  PushPolynomial p;
  p[most_orders] = 1;
  for (int k = most_orders; k > 0; --k) p[k - 1] = place * p[k];
  return p;
}

/// The coefficients around the place with these powers; all orders at once.
void move(PushPolynomial& p, int order, const PushPolynomial& power) {
  PushPolynomial sum{};
  for (int k = 0; k <= order; ++k) {
    const double* from = &power[most_orders - k];
    for (int i = 0; i <= k; ++i) sum[i] += binomial.of[k][i] * from[i] * p[k];
  }
  p = sum;
}

void set_root(const PushPolynomial& square, int order, PushPolynomial& root) {
  root[0] = std::sqrt(square[0]);
  const double share = 0.5 / root[0];
  for (int i = 1; i <= order; ++i) {
    double sum = 0;
    for (int k = 1; 2 * k < i; ++k) sum += root[k] * root[i - k];
    root[i] = share * (square[i] - 2 * sum - (i % 2 == 0 ? root[i / 2] * root[i / 2] : 0));
  }
}

}  // namespace

void drop(PushSeries& series, double begin) {
  const int order = series.order;
  const auto power = powers(begin);
  series.end -= begin;
  if (!series.is_time) move(series.pace, order, power);
  for (auto& c : series.contact) {
    move(c.depth, order, power);
    move(c.rate, order, power);
    if (c.owns_clock)
      c.root = series.pace;
    else if (c.is_curved)
      set_root(c.depth, order, c.root);
  }
}

}  // namespace mariotte::flow
