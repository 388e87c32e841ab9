// Two closed Hertz contacts j between three bodies, x_j = √δ_j, in the clock dt = x₀ x₁ dσ:
//
//   x_j' = x_i δ̇_j/2,   δ̇_j' = c_j x_j x_i⁴ − o_j x_i x_j⁴   with i the other contact
//
// It is polynomial, so that onset and separation of either contact are ordinary points.
#pragma once
#include <array>

namespace mariotte::flow {

/// Each contact has rows of its own: a number may hold many triplets.
struct TripletField {
  static constexpr bool are_paired = false;
  static constexpr int contacts = 2;
  enum { root, rate = root + 2, time = rate + 2, states, rows = states };
  enum { own, cross = own + 2, parameters = cross + 2 };

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    std::array<T, rows> row{};
    const T square0 = x[root] * x[root], square1 = x[root + 1] * x[root + 1];
    const T force0 = (square0 * square0) * x[root + 1], force1 = (square1 * square1) * x[root];
    row[root] = 0.5 * (x[rate] * x[root + 1]);
    row[root + 1] = 0.5 * (x[rate + 1] * x[root]);
    row[rate] = p[cross] * force1 - p[own] * force0;
    row[rate + 1] = p[cross + 1] * force0 - p[own + 1] * force1;
    row[time] = x[root] * x[root + 1];
    return row;
  }
};

/// A number holds both contacts; map 0 gives those of the other one.
struct PairedTripletField {
  static constexpr bool are_paired = true;
  static constexpr int contacts = 1;  ///< both share their rows
  enum { root, rate, time, states, rows = states };
  enum { own, cross, parameters };

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    std::array<T, rows> row{};
    const T square = x[root] * x[root], other = map<0>(x[root]), force = (square * square) * other;
    row[root] = 0.5 * (x[rate] * other);
    row[rate] = p[cross] * map<0>(force) - p[own] * force;
    row[time] = x[root] * other;
    return row;
  }
};

}  // namespace mariotte::flow
