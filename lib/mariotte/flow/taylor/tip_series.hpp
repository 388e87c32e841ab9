// Taylor coefficients of the motion of a body with one tip in contact, in the clock dτ with dt = 2 s dτ,
// s = √δ [numerics page, "An adhesive tip"]. A prime is d/dτ. In this clock every field is a polynomial:
//
//     s' = −w,   P = s²,   Q = k P − k c_H (P w) − b (1 + c_A w),   f = 2 s F = 2 P Q
//     t' = 2 s,  dissipated by damping: 2 k c_H (P w)²  and  2 b c_A (P w) w,  by friction: −y u
//
// w is the normal velocity of the tip, F the normal force, T friction and y = 2 s T. Each `expand` runs
// through the orders once; row[k] is the coefficient of τᵏ.
#pragma once
#include <array>

#include "mariotte/flow/tip_phase.hpp"

namespace mariotte::flow {

inline constexpr int most_order = 24;
/// Coefficients of one quantity, by order.
using PowerSeries = std::array<double, most_order + 2>;

/// The first n of Σ a_j b_{−j}; four sums at once do not wait for each other.
[[gnu::always_inline]] inline double convolution(const double* a, const double* b, int n) {
  double one = 0, two = 0, three = 0, four = 0;
  for (; n >= 4; n -= 4, a += 4, b -= 4) {
    one += a[0] * b[0];
    two += a[1] * b[-1];
    three += a[2] * b[-2];
    four += a[3] * b[-3];
  }
  if (n > 0) one += a[0] * b[0];
  if (n > 1) two += a[1] * b[-1];
  if (n > 2) three += a[2] * b[-2];
  return (one + two) + (three + four);
}

/// Σ a_j b_{k−j}. An order that the compiler knows (`Order` is an integral_constant) leaves no loop. The
/// newest coefficients come last, that of `b` last of all: the rest is summed while they are still on their
/// way.
template <class Order>
double product(const PowerSeries& a, const PowerSeries& b, Order k) {
  if (k == 0) return a[0] * b[0];
  const double known = convolution(a.data() + 1, b.data() + k - 1, k - 1);
  return (known + a[k] * b[0]) + a[0] * b[k];
}
/// Coefficient k of the square of a row.
template <class Order>
double square(const PowerSeries& a, Order k) {
  if (k == 0) return a[0] * a[0];
  const double known = convolution(a.data() + 1, a.data() + k - 1, (k - 1) / 2);
  const double middle = k % 2 == 0 ? a[k / 2] * a[k / 2] : 0;
  return (2 * known + middle) + 2 * a[0] * a[k];
}

/// The normal contact: what all motions share.
struct TipRows {
  PowerSeries s, w, time;
  PowerSeries area;      ///< P = s²
  PowerSeries pressure;  ///< Q = F / s
  PowerSeries force;     ///< f = 2 s F
  PowerSeries rate;      ///< P w
  std::array<PowerSeries, 3> work;

  /// P, P w, Q and f at order k, from s and w up to k.
  template <class Order>
  void contact(const TipPhase& phase, Order k);
  /// s, t and the works of the dampings at order k + 1.
  template <class Order>
  void advance(const TipPhase& phase, Order k);
};

/// Motion along the normal: w' = f/m − 2 s g.
struct NormalSeries : TipRows {
  void expand(const TipPhase& phase, int order);
};

/// Motion in the plane of e1 and the tangent, ω about the axis, tip at d = D (a₁, a₂):
///     cos' = −2 s (ω sin), sin' = 2 s (ω cos), (a₁, a₂) turned by −θ, ℓ₁ = d₁ − r (+ P)
///     w = v₁ + ω d₂,  u = v₂ − ω ℓ₁,  v₁' = f/m − 2 s g,  v₂' = y/m,  I ω' = d₂ f − ℓ₁ y
///     sliding: y = c f, c = −μ σ_F σ_u      sticking: (I/m + ℓ₁²) y = ℓ₁ d₂ f + I ω ℓ₁'
/// ω d₂ and ω ℓ₁ are sums of ω cos and ω sin.
struct PlanarSeries : TipRows {
  PowerSeries normal, tangential, spin, cosine, sine;  ///< v₁, v₂, ω, cos θ, sin θ
  PowerSeries spin_cosine, spin_sine;                  ///< ω cos θ, ω sin θ
  PowerSeries position;                                ///< ∫ v₂ dt
  PowerSeries rise, across, lever;                     ///< a₁, d₂, ℓ₁
  PowerSeries moment, friction, slip;                  ///< d₂ f, y, u
  PowerSeries grip_lever;                              ///< d₂ − c ℓ₁
  PowerSeries inertia, load, lever_rate;               ///< I/m + ℓ₁², its right-hand side, ℓ₁'
  double rise_start, run_start;                        ///< a₁ and a₂ at τ = 0

  void expand(const TipPhase& phase, int order);

 private:
  template <class Order>
  void turn(const TipPhase& phase, Order k);
  template <class Order>
  double torque(const TipPhase& phase, Order k);
  template <class Order>
  void step(const TipPhase& phase, int order, Order k);
  template <class Order>
  void stick(const TipPhase& phase, Order k);
};

/// Motion in space of a symmetric body with unit axis a, angular momentum H and ℓ = D a − r e1 (+ P e1):
///     ω = H/I + κ p a,  p = H·a,  κ = 1/I_a − 1/I
///     a' = 2 s b with b = H × a / I = ω × a,  H' = ℓ × (f, y),  v' = (f, y)/m − 2 s g e1
///     p' = R (a₂ y₃ − a₃ y₂), R = r (− P): only the lever R of friction turns the body about its axis
///     w = v₁ + D b₁,  u = (v + D b − R ω × e1) in the plane
///     ψ' = 2 s (κ p + (p + H·a(0)) / (I (1 + a·a(0))))
///       The attitude is the least turn from a(0) to a after a turn by ψ about a(0).
///     sliding: y = −μ σ_F f u/|u|, with |u|⁻¹ as a power of |u|²
///     u' = A y + N,  N = [κ p a' × ℓ + ω × ℓ'] − ℓ₁ f ℓ/I in the plane,
///       A = (1/m + ℓ²/I) 1 − ℓ ℓᵀ/I + κ r² a⊥ a⊥ᵀ,  a⊥ = (a₃, −a₂)
///     sticking: A y = −N
///     sliding from rest: u = ρ û, y = −μ σ_F f û, |û| = 1, where u' = A y + N gives û_k and ρ_{k+1} at order
///     k
struct SpatialSeries : TipRows {
  using Rows = std::array<PowerSeries, 3>;
  Rows velocity, momentum, axis, spin, lever, axis_rate;
  Rows swing;                         ///< b
  PowerSeries along, axial_torque;    ///< p, a₂ y₃ − a₃ y₂
  PowerSeries alignment, swing_roll;  ///< 1 + a·a(0), (p + H·a(0)) over it
  PowerSeries roll_rate, roll;        ///< dψ/dt, ψ
  std::array<PowerSeries, 2> position, slip, direction, friction;
  PowerSeries slip_square, slip_inverse, grip;                     ///< |u|², 1/|u|, f/|u|
  PowerSeries mobility_22, mobility_23, mobility_33, lever_force;  ///< A and ℓ₁ f
  std::array<PowerSeries, 2> free;                                 ///< N
  PowerSeries speed;                                               ///< ρ of a slip from rest
  PowerSeries grip_22, grip_23, grip_33;                           ///< μ σ_F f A

  void expand(const TipPhase& phase, int order);

 private:
  template <class Order>
  void kinematics(const TipPhase& phase, Order k);
  template <class Order>
  void slide(const TipPhase& phase, Order k);
  template <class Order>
  void respond(const TipPhase& phase, Order k);
  template <class Order>
  void stick(Order k);
  template <class Order>
  void slide_from_rest(const TipPhase& phase, Order k);
  template <class Order>
  void roll_on(const TipPhase& phase, Order k);
  template <class Order>
  void move(const TipPhase& phase, Order k);
  Rows twist_;  ///< κ p a'
};

}  // namespace mariotte::flow
