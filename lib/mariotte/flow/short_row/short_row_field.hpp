// A row of Hertz contacts, one register for each contact, one scene in each lane. The clock is dt = g dσ;
// where a contact c is chosen, g = √δ_c, so that onset and separation of c are ordinary points, else g = 1:
//
//   δ_j' = g δ̇_j
//   δ̇_j' = g (l_j f_{j−1} + r_j f_{j+1} − o_j f_j)   f_j = δ_j √δ_j
//   g' = δ̇_c/2 or 0,   t' = g
#pragma once
#include <array>
#include <cmath>

namespace mariotte::flow {

/// A number holds all contacts. Maps 0 and 1 give the value of the left and the right neighbour, map 2 the
/// sum over all contacts.
struct ShortRowField {
  enum { indentation, rate, clock, time, states, root = states, rows };
  enum {
    curved,  ///< 1 where √δ has to be found, else 0
    level,   ///< 1 − curved
    free,    ///< 0 where √δ is the clock, else 1
    chosen,  ///< 1 − free
    from_left,
    from_right,
    own,
    parameters
  };
  static constexpr bool is_uniform(int row) { return row == clock || row == time; }

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    using std::sqrt;
    std::array<T, rows> row{};
    const T depth = p[curved] * x[indentation] + p[level];
    row[root] = p[free] * sqrt(depth) + p[chosen] * x[clock];
    const T force = (row[root] * x[indentation]) * x[clock];
    row[indentation] = x[rate] * x[clock];
    row[rate] = p[from_left] * map<0>(force) + p[from_right] * map<1>(force) - p[own] * force;
    row[clock] = 0.5 * map<2>(p[chosen] * x[rate]);
    row[time] = x[clock];
    return row;
  }
};

}  // namespace mariotte::flow
