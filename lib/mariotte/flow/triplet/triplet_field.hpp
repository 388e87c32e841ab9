// Two closed Hertz contacts j between three bodies, x_j = √δ_j, in the clock dt = x₀ x₁ dσ:
//
//   x_j' = x_i δ̇_j/2,   δ̇_j' = c_j x_j x_i⁴ − o_j x_i x_j⁴   with i the other contact
//
// It is polynomial, so that onset and separation of either contact are ordinary points.
#pragma once
#include <array>

namespace mariotte::flow {

struct TripletField {
  enum { root0, root1, rate0, rate1, time, states, rows = states };
  enum { own0, own1, cross0, cross1, parameters };

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    std::array<T, rows> row{};
    const T square0 = x[root0] * x[root0], square1 = x[root1] * x[root1];
    const T force0 = (square0 * square0) * x[root1], force1 = (square1 * square1) * x[root0];
    row[root0] = 0.5 * (x[rate0] * x[root1]);
    row[root1] = 0.5 * (x[rate1] * x[root0]);
    row[rate0] = p[cross0] * force1 - p[own0] * force0;
    row[rate1] = p[cross1] * force0 - p[own1] * force1;
    row[time] = x[root0] * x[root1];
    return row;
  }
};

}  // namespace mariotte::flow
