// Fields that the library does not need, to show what a field can be.
#pragma once
#include <array>
#include <cmath>

namespace mariotte::test {

/// A sphere that necks [Johnson, Kendall & Roberts 1971]: b² is the contact radius a, δ = a²/R − c√a and
/// F = k a³ − e a^{3/2}. In the clock dt = (dδ/db) dσ the fold where the contact lets go is an ordinary
/// point.
struct Jkr {
  enum { b, speed, time, states, force = states, indentation, rows };
  enum { radius, c, k, e, mass, parameters };
  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    const T square = x[b] * x[b], cube = square * x[b];
    const T pace = (4.0 / p[radius]) * cube - p[c];
    const T f = p[k] * (cube * cube) - p[e] * cube;
    std::array<T, rows> row{};
    row[b] = x[speed];
    row[speed] = -(f * pace) / p[mass];
    row[time] = pace;
    row[force] = f;
    row[indentation] = square * square / p[radius] - p[c] * x[b];
    return row;
  }
};

/// Two spheres that turn about each other in a plane, with a tangential spring [Mindlin 1949, constant area]
/// that sticks, or with sliding friction; y = √δ, dt = 2 y dτ.
template <bool slides>
struct Mindlin {
  enum { y, approach, across, first_spin, second_spin, stretch, angle, heat, states, slip = states, rows };
  enum { stiffness, shear, damping, friction, mass, r1, r2, inertia1, inertia2, parameters };
  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    const T pace = 2.0 * x[y], depth = x[y] * x[y];
    const T turn = x[across] / (p[r1] + p[r2] - depth);
    const T arm1 = p[r1] - 0.5 * depth, arm2 = p[r2] - 0.5 * depth;
    const T u = x[across] + arm1 * x[first_spin] + arm2 * x[second_spin];
    const T normal = pace * (x[y] * (p[stiffness] * depth + p[damping] * x[approach]));
    const T tangential = slides ? T(p[friction] * normal) : T(pace * (p[shear] * (x[y] * x[stretch])));
    std::array<T, rows> row{};
    row[y] = x[approach];
    row[approach] = -(pace * x[across]) * turn - normal / p[mass];
    row[across] = (pace * x[approach]) * turn - tangential / p[mass];
    row[first_spin] = -(arm1 * tangential) / p[inertia1];
    row[second_spin] = -(arm2 * tangential) / p[inertia2];
    row[stretch] = slides ? T(0.0) : T(pace * u);
    row[angle] = pace * turn;
    row[heat] = slides ? T(tangential * u) : T(0.0);
    row[slip] = u;
    return row;
  }
};

/// Every operation, some of them on constants, and sums that several things need.
struct Everything {
  enum { a, b, c, d, states, echo = states, same, fixed_value, rows };
  enum { n, q, parameters };
  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    using std::sqrt, std::exp, std::pow, std::sin, std::cos;
    const T shared = x[a] - 2.0 * (x[b] - p[q]) + 0.5;
    const T root = sqrt(shared + 3.0), power = pow(x[b], p[n] + 0.25);
    std::array<T, rows> row{};
    row[a] = sin(x[c]) * cos(x[a] + x[b]) - (3.0 * x[a]) * (2.0 * x[a]) / p[q];
    row[b] = exp(-(x[a] * x[b])) + sqrt(p[q]) * power / (x[c] * 2.0);
    row[c] = 1.0 / root + shared * shared - exp(sin(p[q])) * pow(p[q], p[n]) * x[b];
    row[d] = p[q] * (p[n] * 4.0) / 2.0;
    row[echo] = x[b];
    row[same] = power;
    row[fixed_value] = cos(p[n]) / p[q];
    return row;
  }
};

/// A row of four equal balls between two more: one number is one contact, maps 0 and 1 are its neighbours'.
struct BallRow {
  enum { depth, rate, states, rows = states };
  enum { stiffness, parameters };
  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    using std::sqrt;
    const T force = p[stiffness] * (sqrt(x[depth]) * x[depth]);
    std::array<T, rows> row{};
    row[depth] = x[rate];
    row[rate] = map<0>(force) - 2.0 * force + map<1>(force);
    return row;
  }
};

}  // namespace mariotte::test
