// The fields of contacts of balls in the plane, side by side; a number holds many contacts. In a clock
// dt = g dσ, with the normal n from a to b, the tangent t = e_z × n and the velocity v of b on a:
//
//   w = −n·v,  h = t·v,  n' = g h/(R − δ) t,  δ' = g w        R the sum of radii
//   s = √δ, or 1 for a linear law;   f_n = k s δ
//   u = h − Σ r ω + δ Σ share ω      slip
//   f_t = −(a + b s) S − c s δ       S: T or ξ of a spring that sticks
//   S' = g (d + e s) u
//   y = u − (p + q s) w              of a slip the rate, times its sign, at which it gives way
//
// Whoever knows all contacts gives velocities, spins and the clock, and √δ where δ begins at zero.
#pragma once
#include <array>
#include <cmath>

namespace mariotte::flow {

struct ClusterField {
  enum {
    normal_x,
    normal_y,
    depth,      ///< δ
    spring,     ///< S
    impulse_x,  ///< ∫ f dt on b
    impulse_y,
    normal,      ///< ∫ f_n dt
    tangential,  ///< ∫ f_t dt
    moment,      ///< ∫ δ f_t dt
    work,        ///< against friction: of a slip what it loses
    velocity_x,  ///< v
    velocity_y,
    spins,   ///< Σ r ω
    shared,  ///< Σ share ω
    root,    ///< s where it is `given`
    clock,   ///< g
    states,
    approach = states,  ///< w
    yielding,           ///< y
    force,              ///< f_n
    friction,           ///< f_t
    rows
  };
  enum {
    stiffness,  ///< k
    radii,      ///< R
    turning,    ///< 1; 0 of a plane, whose normal rests
    hold,       ///< a
    hold_root,  ///< b
    directed,   ///< c
    stretch,    ///< d
    stretch_root,
    growth,  ///< p
    growth_root,
    curved,  ///< 1 where √δ is found here
    level,   ///< 1 − curved
    given,   ///< 1 where it is given
    found,   ///< 1 − given
    parameters
  };
  static constexpr bool is_uniform(int row) { return row == clock; }

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    using std::sqrt;
    std::array<T, rows> row{};
    const T &n1 = x[normal_x], &n2 = x[normal_y], &g = x[clock];
    const T s = p[found] * sqrt(p[curved] * x[depth] + p[level]) + p[given] * x[root], push = s * x[depth];
    const T w = -(n1 * x[velocity_x]) - n2 * x[velocity_y], h = n1 * x[velocity_y] - n2 * x[velocity_x];
    const T slip = h - x[spins] + x[depth] * x[shared];
    const T turns = (p[turning] * h / (p[radii] - x[depth])) * g;
    row[approach] = w;
    row[yielding] = slip - p[growth] * w - p[growth_root] * (s * w);
    row[force] = p[stiffness] * push;
    row[friction] = -(p[hold] * x[spring]) - p[hold_root] * (s * x[spring]) - p[directed] * push;
    row[normal_x] = -(n2 * turns);
    row[normal_y] = n1 * turns;
    row[depth] = w * g;
    row[spring] = (p[stretch] * slip + p[stretch_root] * (s * slip)) * g;
    row[normal] = row[force] * g;
    row[tangential] = row[friction] * g;
    row[impulse_x] = n1 * row[normal] - n2 * row[tangential];
    row[impulse_y] = n2 * row[normal] + n1 * row[tangential];
    row[moment] = x[depth] * row[tangential];
    row[work] = -(row[yielding] * row[tangential]);
    return row;
  }
};

}  // namespace mariotte::flow
