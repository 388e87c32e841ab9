// The fields of one Hertz contact of balls in the plane, in the clock dt = x dσ with x = √δ [numerics page,
// "Bodies with friction"]. In this clock they are polynomials, through the beginning and the end of the
// contact, but for the turning of the normal and the rigid stick:
//
//     x' = w/2,   F = x f_n = k x⁴,   G = x f_t,   θ' = x h/(R − δ)
//     w' = −F/m − x g_n − θ' h,       h' = G/m + x g_t + θ' w
//     ω' = −(r − s δ) G/J for a and b, u = h − Σ (r − s δ) ω
//
// A prime is d/dσ; w = δ̇, h is the velocity of b on a across the line of centres, R the sum of radii.
#pragma once
#include <array>

#include "mariotte/core/mindlin.hpp"

namespace mariotte::flow {

/// How friction acts: stick of a rigid contact or of a Mindlin spring on loading and on unloading, slip of
/// either.
enum class Grip {
  none,
  rigid_stick,
  rigid_slip,
  stick_loading,
  stick_unloading,
  slip_loading,
  slip_unloading
};
inline constexpr int grips = 7;

constexpr bool sticks(Grip grip) {
  return grip == Grip::rigid_stick || grip == Grip::stick_loading || grip == Grip::stick_unloading;
}
constexpr bool unloads(Grip grip) {
  return grip == Grip::stick_unloading || grip == Grip::slip_unloading;
}

/// Rows and parameters of all of them; a is the plane or a ball, b a ball.
struct BallMotion {
  enum {
    root,      ///< x
    approach,  ///< w
    along,     ///< h
    spin_a,
    spin_b,
    spring,  ///< T on loading, ξ on unloading
    time,
    turned,  ///< of the normal
    run,     ///< ∫ h dt
    turn_a,
    turn_b,
    normal,      ///< ∫ f_n dt
    tangential,  ///< ∫ f_t dt
    lost,        ///< by slip
    rescaled,    ///< in a stick; on loading the work against friction instead
    states,
    depth = states,  ///< δ
    force,           ///< f_n
    friction,        ///< f_t, of the cap where it slips
    watched,  ///< of a slip its speed, or the rate at which it yields; of a rigid stick cap² − f_t²
    rows
  };
  enum {
    stiffness,
    inverse_mass,
    radii,  ///< R
    pull_normal,
    pull_along,
    radius_a,
    radius_b,
    share_a,  ///< of the overlap, by which the lever is shorter
    share_b,
    ease_a,  ///< 1/J
    ease_b,
    coulomb,         ///< μ
    directed,        ///< μ times the sign of slip
    sign,            ///< of slip
    growth,          ///< μ k/κ
    grip_stiffness,  ///< κ
    parameters
  };
};

/// x f_t, and what else follows from how friction acts.
template <class T>
struct BallGrip {
  T push;      ///< x f_t
  T friction;  ///< f_t
};

/// Two balls if `pair`, else a ball on a plane.
template <Grip grip, bool pair>
struct BallField : BallMotion {
  template <class T>
  using State = std::array<T, states>;
  template <class T>
  using Numbers = std::array<T, parameters>;

  template <class T>
  static constexpr auto rates(const State<T>& x, const Numbers<T>& p) {
    std::array<T, rows> row{};
    const T depth = x[root] * x[root], push = p[stiffness] * (depth * depth);
    const T turning = pair ? x[along] / (p[radii] - depth) : T(0.0), turns = x[root] * turning;
    row[BallMotion::depth] = depth;
    row[force] = p[stiffness] * (x[root] * depth);
    const T spins = p[share_a] * x[spin_a] + p[share_b] * x[spin_b];
    const T slip = x[along] - p[radius_a] * x[spin_a] - p[radius_b] * x[spin_b] + depth * spins;
    const T drift = p[pull_along] + x[approach] * (turning + spins);
    const auto held = hold(x, p, depth, push, row[force], drift);

    row[root] = 0.5 * x[approach];
    row[approach] = -(p[inverse_mass] * push) - p[pull_normal] * x[root] - turns * x[along];
    row[along] = p[inverse_mass] * held.push + p[pull_along] * x[root] + turns * x[approach];
    const T inside = depth * held.push;
    row[spin_a] = p[ease_a] * (p[share_a] * inside - p[radius_a] * held.push);
    row[spin_b] = p[ease_b] * (p[share_b] * inside - p[radius_b] * held.push);
    row[time] = x[root];
    row[turned] = turns;
    row[run] = pair ? T(0.0) : x[root] * x[along];
    row[turn_a] = pair ? x[root] * x[spin_a] : T(0.0);
    row[turn_b] = x[root] * x[spin_b];
    row[normal] = push;
    row[tangential] = held.push;
    row[friction] = held.friction;
    put_grip(x, p, slip, depth, push, held, row);
    return row;
  }

 private:
  /// `drift` is how fast the slip would grow without friction.
  template <class T>
  static constexpr BallGrip<T> hold(const State<T>& x, const Numbers<T>& p, const T& depth, const T& push,
                                    const T& force, const T& drift) {
    if constexpr (grip == Grip::none) return {T(0.0), T(0.0)};
    if constexpr (grip == Grip::stick_loading) return {-(x[root] * x[spring]), -x[spring]};
    if constexpr (grip == Grip::stick_unloading)
      return {-(p[grip_stiffness] * (depth * x[spring])), -(p[grip_stiffness] * (x[root] * x[spring]))};
    if constexpr (grip == Grip::rigid_stick) {
      const T a = p[radius_a] - p[share_a] * depth, b = p[radius_b] - p[share_b] * depth;
      const T needed = -(drift / (p[inverse_mass] + p[ease_a] * (a * a) + p[ease_b] * (b * b)));
      return {x[root] * needed, needed};
    }
    return {-(p[directed] * push), -(p[directed] * force)};
  }

  /// Rates of spring and losses, and what is watched.
  template <class T>
  static constexpr void put_grip(const State<T>& x, const Numbers<T>& p, const T& slip, const T& depth,
                                 const T& push, const BallGrip<T>& held, std::array<T, rows>& row) {
    if constexpr (grip == Grip::stick_loading) {
      row[spring] = p[grip_stiffness] * (depth * slip);
      row[rescaled] = -(held.push * slip);
    } else if constexpr (grip == Grip::stick_unloading) {
      row[spring] = x[root] * slip;
      row[rescaled] = (-0.25 * p[grip_stiffness]) * (x[spring] * x[spring] * x[approach]);
    } else if constexpr (grip == Grip::rigid_stick) {
      const T cap = p[coulomb] * row[force];
      row[watched] = cap * cap - held.friction * held.friction;
    } else if constexpr (grip == Grip::rigid_slip) {
      row[watched] = p[sign] * slip;
      row[lost] = p[coulomb] * (push * row[watched]);
    } else if constexpr (grip != Grip::none) {
      row[watched] = mindlin_yielding(p[sign] * slip, p[growth], x[approach], unloads(grip));
      row[lost] = p[coulomb] * (push * row[watched]);
    }
  }
};

}  // namespace mariotte::flow
