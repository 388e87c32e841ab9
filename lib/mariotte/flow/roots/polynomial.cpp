#include "mariotte/flow/roots/polynomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "mariotte/core/types.hpp"

namespace mariotte::flow {
namespace {

constexpr std::size_t most_coefficients = 32;
constexpr int deepest_halving = 50;  ///< halvings until an interval is shorter than rounding
using Bernstein = std::array<double, most_coefficients>;

/// C(j,k)/C(n,k) at [k][j]: what the power k adds to the Bernstein coefficient j.
using Shares = std::array<Bernstein, most_coefficients>;

Shares make_shares(std::size_t n) {
  Shares share{};
  for (std::size_t j = 0; j <= n; ++j) share[0][j] = 1;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = k + 1; j <= n; ++j)
      share[k + 1][j] = share[k][j] * static_cast<double>(j - k) / static_cast<double>(n - k);
  return share;
}

const Shares& shares(std::size_t n) {
  static const auto all = [] {
    std::array<Shares, most_coefficients> table;
    for (std::size_t degree = 0; degree < table.size(); ++degree) table[degree] = make_shares(degree);
    return table;
  }();
  return all[n];
}

/// Bernstein coefficients on [0, end] from powers, b_j = Σ_{k≤j} C(j,k)/C(n,k) a_k endᵏ.
Bernstein from_powers(std::span<const double> c, double end) {
  const auto& share = shares(c.size() - 1);
  Bernstein b{};
  double power = 1;
  for (std::size_t k = 0; k < c.size(); ++k, power *= end) {
    const double term = c[k] * power;
    for (std::size_t j = k; j < c.size(); ++j) b[j] += share[k][j] * term;
  }
  return b;
}

/// De Casteljau at the middle: `left` becomes the left half and the right half is returned.
Bernstein halve(Bernstein& left, std::size_t n) {
  Bernstein right{};
  for (std::size_t i = 0; i <= n; ++i) {
    right[n - i] = left[n];
    for (std::size_t j = n; j > i; --j) left[j] = 0.5 * (left[j] + left[j - 1]);
  }
  return right;
}

/// What the terms from the fourth on can take away from Σ factor(k) c[k] xᵏ on [0, end], over end⁴.
template <class Factor>
double loss(std::span<const double> c, double end, Factor&& factor) {
  const auto lost = [&](std::size_t k) {  // twice as much: without a branch on signs, which nothing foretells
    const double term = factor(k) * c[k];
    return std::abs(term) - term;
  };
  const double square = end * end;
  const bool is_single = c.size() % 2 == 1 && c.size() > 4;
  double even = is_single ? lost(c.size() - 1) : 0, odd = 0;  // apart so that neither sum waits for the other
  for (std::size_t k = c.size() - is_single; k > 4; k -= 2) {
    odd = odd * square + lost(k - 1);
    even = even * square + lost(k - 2);
  }
  return 0.5 * (even + end * odd);
}

/// Of Σ factor(k) c[k] xᵏ on [0, end]: the Bernstein form of four terms less, if that is positive, what the
/// others can take away.
template <class Factor>
double lower_bound(std::span<const double> c, double end, Factor&& factor) {
  const auto term = [&](std::size_t k) { return k < c.size() ? factor(k) * c[k] : 0; };
  const double square = end * end;
  const double a = term(0), b = end * term(1), d = square * term(2), e = square * end * term(3);
  const double inner = std::min(a + b / 3, a + (2 * b + d) / 3), least = std::min({a, inner, a + b + d + e});
  return least > 0 ? least - square * square * loss(c, end, factor) : least;
}
double lower_bound(std::span<const double> c, double end) {
  return lower_bound(c, end, [](std::size_t) { return 1.0; });
}

/// The second derivative is provably negative on [0, end]: what starts positive has one root at most.
bool bends_down(std::span<const double> c, double end) {
  if (c.size() < 3) return false;
  const auto curvature = c.subspan(2);
  return lower_bound(curvature, end, [](std::size_t k) { return -static_cast<double>((k + 1) * (k + 2)); }) >
         0;
}

/// Even and odd powers apart, so that neither sum waits for the other.
struct ValueAndSlope {
  double value, slope;

  ValueAndSlope(std::span<const double> c, double x) {
    const double square = x * x;
    const bool is_single = c.size() % 2 == 1;
    double even = is_single ? c.back() : 0, odd = 0, even_slope = 0, odd_slope = 0;  // slopes by x²
    for (std::size_t k = c.size() - is_single; k > 0; k -= 2) {
      odd_slope = odd_slope * square + odd;
      even_slope = even_slope * square + even;
      odd = odd * square + c[k - 1];
      even = even * square + c[k - 2];
    }
    value = even + x * odd;
    slope = odd + 2 * x * (even_slope + x * odd_slope);
  }
};

/// Where a polynomial that falls from `first` to `last` may have its root: from low = 0 on that of its first
/// three terms, if they have one, else by the secant.
double near_root(std::span<const double> c, double low, double high, double first, double last) {
  const double bend = c.size() > 2 ? c[2] : 0, square = c[1] * c[1] - 4 * c[0] * bend;
  const double early = square >= 0 && c[1] < 0 ? 2 * c[0] / (std::sqrt(square) - c[1]) : infinity;
  if (low == 0 && early < high) return early;
  return low + (high - low) * first / (first - last);
}

/// Newton's method for the root of a polynomial that falls through zero once from low to high, kept between
/// them; infinite if it does not fall so far. The next step is as the square of this one; it is not taken
/// where that is rounding.
double only_root(std::span<const double> c, double low, double high) {
  const double first = low == 0 ? c[0] : horner(c, low), last = horner(c, high);
  if (last > 0) return infinity;
  if (!(first > 0)) return low;
  double x = near_root(c, low, high, first, last), before = 0;
  for (int i = 0; i < 60; ++i) {
    const ValueAndSlope at(c, x);
    (at.value > 0 ? low : high) = x;
    double next = x - at.value / at.slope;
    const bool leaves = !(next >= low && next <= high);
    if (leaves) next = 0.5 * (low + high);
    const double step = std::abs(next - x), bend = std::max(4 / next, step / (before * before));
    if (step <= 2 * epsilon * next || bend * step * step <= epsilon * next) return next;
    before = leaves ? 0 : step;
    x = next;
  }
  return x;
}

struct Search {
  std::span<const double> c;
  std::size_t n;

  /// The first fall, or infinity; the polynomial is positive right of `from`.
  double first(Bernstein b, double from, double to, int depth) const {
    const auto last = b.begin() + static_cast<Index>(n) + 1;
    if (std::all_of(b.begin() + 1, last, [](double value) { return value > 0; })) return infinity;
    if (std::is_sorted(b.begin(), last, std::greater<>()) || depth == deepest_halving)
      return only_root(c, from, to);
    const auto right = halve(b, n);
    const double middle = 0.5 * (from + to);
    if (const double early = first(b, from, middle, depth + 1); early != infinity) return early;
    if (right[0] <= 0) return middle;
    return first(right, middle, to, depth + 1);
  }
};

}  // namespace

double horner(std::span<const double> c, double x) {
  const double square = x * x;
  const bool is_single = c.size() % 2 == 1;
  double even = is_single ? c.back() : 0, odd = 0;
  for (std::size_t k = c.size() - is_single; k > 0; k -= 2) {
    odd = odd * square + c[k - 1];
    even = even * square + c[k - 2];
  }
  return even + x * odd;
}

bool falls(std::span<const double> c, double end) {
  const auto slope = c.subspan(1);
  return lower_bound(slope, end, [](std::size_t k) { return -static_cast<double>(k + 1); }) > 0;
}

double place_of_fall(std::span<const double> c, double end) {
  while (c.size() > 1 && c[0] == 0) c = c.subspan(1);  // a root at 0 is divided out
  if (c.size() < 2) return infinity;
  if (lower_bound(c, end) > 0) return infinity;
  if (falls(c, end)) return only_root(c, 0, end);
  if (c[0] > 0 && lower_bound(c.subspan(1), end) > 0) return infinity;
  if (c[0] > 0 && bends_down(c, end)) return only_root(c, 0, end);
  const Search search{c, c.size() - 1};
  return search.first(from_powers(c, end), 0, end, 0);
}

double rise_to(std::span<const double> c, double value, double end) {
  const double last = horner(c, end);
  if (!(last > value)) return end;
  if (!(value > 0)) return 0;
  double low = 0, high = end, x = end * std::sqrt(value / last);  // straight or square growth is soon found
  for (int i = 0; i < 100; ++i) {
    const ValueAndSlope at(c, x);
    (at.value > value ? high : low) = x;
    double next = x - (at.value - value) / at.slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - x) <= 4 * epsilon * x) return next;
    x = next;
  }
  return x;
}

}  // namespace mariotte::flow
