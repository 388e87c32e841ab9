// A sphere in contact with a plane, s = √δ, in the clock dt = 2 s dσ:
//
//   s' = δ̇,   δ̇' = −2 s² (s² (1 + c_H δ̇) − b (1 − c_A δ̇)),   t' = 2 s
#pragma once
#include <array>

namespace mariotte::flow {

struct SphereField {
  static constexpr bool are_paired = false;
  static constexpr int contacts = 1;
  enum { root, rate, time, states, rows = states };
  enum { adhesion, damping_hertz, damping_adhesion, parameters };

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    const T area = x[root] * x[root];
    const T pressure = area + p[damping_hertz] * (area * x[rate]) - p[adhesion] +
                       (p[adhesion] * p[damping_adhesion]) * x[rate];
    return std::array<T, rows>{x[rate], -2.0 * (area * pressure), 2.0 * x[root]};
  }
};

}  // namespace mariotte::flow
