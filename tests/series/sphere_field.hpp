// A damped sphere against a plane, y = √δ, in the clock dt = 2 y dτ.
#pragma once
#include <array>

struct SphereField {
  enum { y, speed, states, force = states, rows };
  enum { stiffness, damping, mass, parameters };
  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    const T area = x[y] * x[y];
    std::array<T, rows> row{};
    row[force] = p[stiffness] * (area * (area + p[damping] * (area * x[speed])));
    row[y] = x[speed];
    row[speed] = -2.0 * (row[force] / p[mass]);
    return row;
  }
};
