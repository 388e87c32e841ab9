// Collocation in eight Gauss points of [0, 1], and whether they resolve what they are asked for.
#pragma once
#include <algorithm>

namespace mariotte::impact {

inline constexpr int stages = 8;
inline constexpr int tail_length = 4;

/// Points, weights b, ∫₀^{c_i} of the Lagrange polynomials, and of a function at the points its four highest
/// Legendre coefficients. `log_rest` is what ∫₀¹ of these polynomials times ln u is beyond b_i ln c_i.
struct Gauss {
  double point[stages], weight[stages], log_rest[stages];
  double integral[stages][stages];
  double tail[tail_length][stages];

  Gauss();
};
extern const Gauss gauss;

/// Error of the integral relative to the function, from the highest coefficients of an interpolant relative
/// to the function: those of the two orders before the last two, and of these. Gauss' formula has twice the
/// order of its interpolant, so its error is the coefficient so far beyond the last ones, if they go on to
/// fall as they do. Next to a root they are small but fall slowly.
double remainder(double before, double last);
/// More than this is not resolved, however it falls.
double largest_tail(double accuracy);
bool is_resolved(double before, double last, double accuracy);

/// Of functions that are integrated together: each falls as it does.
struct Tail {
  double last = 0;  ///< largest coefficients of the last two orders
  double rest = 0;  ///< largest remainder

  void add(double before, double after) {
    last = std::max(last, after);
    rest = std::max(rest, remainder(before, after));
  }
};
bool is_resolved(const Tail& tail, double accuracy);

}  // namespace mariotte::impact
