// The fields of a body with one tip in contact, in the clock dτ with dt = 2 s dτ, s = √δ [numerics page, "A
// microbody"]. In this clock every field is a polynomial or a quotient of two:
//
//     s' = −w,   P = s²,   Q = k P − k c_H (P w) − b (1 + c_A w),   f = 2 s F = 2 P Q
//     t' = 2 s,  dissipated by damping: 2 k c_H (P w)²  and  2 b c_A (P w) w,  by friction: −y u
//
// A prime is d/dτ, w the normal velocity of the tip, F the normal force, T friction, u the slip, y = 2 s T.
// `works` says whether position and dissipated energies are followed.
#pragma once
#include <array>
#include <cmath>

namespace mariotte::flow {

/// Parameters of all motions.
struct TipParameters {
  enum { stiffness, adhesion, damping_hertz, damping_adhesion, mass, gravity, common };
};

/// What all motions share: the normal contact.
template <class T>
struct TipContact {
  T area, rate, pressure, force;  ///< P, P w, Q, f
};
template <class Motion, class T>
constexpr TipContact<T> tip_contact(const T& s, const T& w, const std::array<T, Motion::parameters>& p) {
  const T area = s * s, rate = area * w;
  const T pressure = p[Motion::stiffness] * (area - p[Motion::damping_hertz] * rate) -
                     p[Motion::adhesion] * (1.0 + p[Motion::damping_adhesion] * w);
  return {area, rate, pressure, 2.0 * (area * pressure)};
}
template <class Motion, bool works, class T>
constexpr void tip_common(const T& s, const T& w, const TipContact<T>& contact,
                          const std::array<T, Motion::parameters>& p, std::array<T, Motion::rows>& row) {
  row[Motion::s] = -w;
  row[Motion::time] = 2.0 * s;
  row[Motion::area] = contact.area;
  row[Motion::pressure] = contact.pressure;
  row[Motion::force] = contact.force;
  if constexpr (!works) return;
  row[Motion::work] =
      (2.0 * (p[Motion::stiffness] * p[Motion::damping_hertz])) * (contact.rate * contact.rate);
  row[Motion::work + 1] = (2.0 * (p[Motion::adhesion] * p[Motion::damping_adhesion])) * (contact.rate * w);
}

/// Rows of the motion along the normal: w' = f/m − 2 s g.
struct NormalMotion : TipParameters {
  enum { s, w, time, work, states = work + 3, area = states, pressure, force, rows };
  enum { parameters = common };
};
template <bool works>
struct NormalField : NormalMotion {
  using Motion = NormalMotion;
  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    const auto contact = tip_contact<NormalMotion>(x[s], x[w], p);
    std::array<T, rows> row{};
    tip_common<NormalMotion, works>(x[s], x[w], contact, p, row);
    row[w] = contact.force / p[mass] - p[gravity] * (2.0 * x[s]);
    return row;
  }
};

/// Rows of the motion in the plane of e1 and the tangent: v₁, v₂, ω about the axis, cos and sin of the angle
/// θ turned, ∫ v₂ dt; w, ℓ₁' axis a₁, u, y.
struct PlanarMotion : TipParameters {
  enum { s, normal, tangential, spin, cosine, sine, time, position, work, states = work + 3 };
  enum { w = states, area, pressure, force, rise, slip, friction, rows };
  enum {
    inertia = common,
    arm,
    radius,
    sinking,  ///< 1 if the lever of friction is r − δ, else 0
    rise_start,
    run_start,  ///< a₁ and a₂ at τ = 0
    sliding,    ///< −μ σ_F σ_u
    parameters
  };
};
/// The tip is at d = D (a₁, a₂), turned by −θ, friction acts at ℓ₁ = d₁ − r (+ P):
///     cos' = −2 s ω sin,  sin' = 2 s ω cos,  w = v₁ + ω d₂,  u = v₂ − ω ℓ₁
///     v₁' = f/m − 2 s g,  v₂' = y/m,  I ω' = d₂ f − ℓ₁ y
///     sliding: y = −μ σ_F σ_u f      sticking: (I/m + ℓ₁²) y = ℓ₁ d₂ f + I ω ℓ₁'
template <bool sticks, bool works>
struct PlanarField : PlanarMotion {
  using Motion = PlanarMotion;
  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    const T pace = 2.0 * x[s];
    const T turn = pace * x[spin];
    const T up = p[rise_start] * x[cosine] + p[run_start] * x[sine];
    const T across = p[arm] * (p[run_start] * x[cosine] - p[rise_start] * x[sine]);
    const T speed = x[normal] + x[spin] * across;
    const auto contact = tip_contact<PlanarMotion>(x[s], speed, p);
    const T lever = p[arm] * up + p[sinking] * contact.area - p[radius];
    const T u = x[tangential] - x[spin] * lever;
    std::array<T, rows> row{};
    tip_common<PlanarMotion, works>(x[s], speed, contact, p, row);
    row[cosine] = -(turn * x[sine]);
    row[sine] = turn * x[cosine];
    if constexpr (sticks) {
      const T lever_rate =
          p[arm] * (p[rise_start] * row[cosine] + p[run_start] * row[sine]) - p[sinking] * (pace * speed);
      const T moment = across * contact.force;
      row[friction] =
          (lever * moment + p[inertia] * (x[spin] * lever_rate)) / (lever * lever + p[inertia] / p[mass]);
      row[spin] = (moment - lever * row[friction]) / p[inertia];
    } else {
      row[friction] = p[sliding] * contact.force;
      row[spin] = ((across - p[sliding] * lever) * contact.force) / p[inertia];
      if constexpr (works) row[work + 2] = -(row[friction] * u);
    }
    row[normal] = contact.force / p[mass] - p[gravity] * pace;
    row[tangential] = row[friction] / p[mass];
    if constexpr (works) row[position] = pace * x[tangential];
    row[w] = speed;
    row[rise] = up;
    row[slip] = u;
    return row;
  }
};

/// Rows of the motion in space of a symmetric body: velocity of the mass centre, angular momentum H, unit
/// axis a, p = H·a, turn ψ, position in the plane, and û where the slip starts from rest; w, and in the plane
/// ω, u, y, u'.
struct SpatialMotion : TipParameters {
  enum {
    s,
    velocity,
    momentum = velocity + 3,
    axis = momentum + 3,
    along = axis + 3,
    roll,
    time,
    position,
    work = position + 2,
    direction = work + 3,
    states = direction + 2
  };
  enum {
    w = states,
    area,
    pressure,
    force,
    spin,
    slip = spin + 2,
    friction = slip + 2,
    slip_rate = friction + 2,
    rows = slip_rate + 2
  };
  enum {
    inverse = common,  ///< 1/I
    twist,             ///< κ = 1/I_a − 1/I
    arm,
    radius,
    limit,       ///< μ σ_F
    axis_start,  ///< a(0)
    parameters = axis_start + 3
  };
};
/// How a tip holds on to the plane in space.
enum class Grip { none, sliding, sinking_sliding, sticking, from_rest };

/// With ω = H/I + κ p a, p = H·a and ℓ = D a − R e1, R = r (− P):
///     a' = 2 s b with b = H × a / I = ω × a,  H' = ℓ × (f, y),  v' = (f, y)/m − 2 s g e1
///     p' = R (a₂ y₃ − a₃ y₂): only the lever R of friction turns the body about its axis
///     w = v₁ + D b₁,  u = (v + D b − R ω × e1) in the plane
///     ψ' = 2 s (κ p + (p + H·a(0)) / (I (1 + a·a(0))))
///       The attitude is the least turn from a(0) to a after a turn by ψ about a(0).
///     sliding: y = −μ σ_F f u/|u|
///     sticking: y = −A⁻¹ N, so that u' = A y + N = 0, where in the plane, with n = (a₂, a₃),
///       N = (D/I) (a₁' (H₃, −H₂) − ℓ₁ f n) + (κ r p + (D/I) H₁) (−a₃', a₂')
///       A = λ₂ 1 − c n nᵀ,  A⁻¹ = (1 + (c/λ₁) n nᵀ)/λ₂
///       c = D²/I + κ r²,  λ₁ = 1/m + ℓ₁²/I,  λ₂ = λ₁ + c n·n
///     from rest: y = −μ σ_F f û, where û is given order by order.
template <Grip grip, bool works>
struct SpatialField : SpatialMotion {
  using Motion = SpatialMotion;
  static constexpr bool knows_rest = grip == Grip::sticking || grip == Grip::from_rest;

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    const T pace = 2.0 * x[s];
    const std::array<T, 3> a{x[axis], x[axis + 1], x[axis + 2]};
    const std::array<T, 3> h{x[momentum], x[momentum + 1], x[momentum + 2]};
    const std::array<T, 3> swing{p[inverse] * (h[1] * a[2] - h[2] * a[1]),
                                 p[inverse] * (h[2] * a[0] - h[0] * a[2]),
                                 p[inverse] * (h[0] * a[1] - h[1] * a[0])};
    std::array<T, rows> row{};
    row[w] = x[velocity] + p[arm] * swing[0];
    const auto contact = tip_contact<SpatialMotion>(x[s], row[w], p);
    tip_common<SpatialMotion, works>(x[s], row[w], contact, p, row);
    const T turn = p[twist] * x[along];
    for (int i = 0; i < 3; ++i) row[axis + i] = pace * swing[i];
    for (int i = 0; i < 2; ++i) row[spin + i] = p[inverse] * h[i + 1] + turn * a[i + 1];
    const T reach = grip == Grip::sinking_sliding ? p[radius] - contact.area : p[radius];
    row[slip] = x[velocity + 1] + p[arm] * swing[1] - reach * row[spin + 1];
    row[slip + 1] = x[velocity + 2] + p[arm] * swing[2] + reach * row[spin];
    grip_plane(x, p, p[arm] * a[0] - reach, row);
    move(x, p, reach, row);
    return row;
  }

 private:
  /// Friction.
  template <class T>
  static constexpr void grip_plane(const std::array<T, states>& x, const std::array<T, parameters>& p,
                                   const T& lever, std::array<T, rows>& row) {
    using std::sqrt;
    if constexpr (grip == Grip::sliding || grip == Grip::sinking_sliding) {
      const T held = row[force] / sqrt(row[slip] * row[slip] + row[slip + 1] * row[slip + 1]);
      for (int i = 0; i < 2; ++i) row[friction + i] = -p[limit] * (held * row[slip + i]);
    }
    if constexpr (!knows_rest) return;
    const T &n2 = x[axis + 1], &n3 = x[axis + 2];
    const T share = p[arm] * p[inverse], c = p[arm] * share + p[twist] * (p[radius] * p[radius]);
    const T turn = p[twist] * p[radius] * x[along] + share * x[momentum], pressed = lever * row[force];
    const T free2 = share * (row[axis] * x[momentum + 2] - pressed * n2) - turn * row[axis + 2];
    const T free3 = turn * row[axis + 1] - share * (row[axis] * x[momentum + 1] + pressed * n3);
    const T least = 1.0 / p[mass] + p[inverse] * (lever * lever), most = least + c * (n2 * n2 + n3 * n3);
    if constexpr (grip == Grip::sticking) {
      const T along_n = c * ((n2 * free2 + n3 * free3) / least);
      row[friction] = -((free2 + along_n * n2) / most);
      row[friction + 1] = -((free3 + along_n * n3) / most);
    } else if constexpr (grip == Grip::from_rest) {
      for (int i = 0; i < 2; ++i) row[friction + i] = -p[limit] * (row[force] * x[direction + i]);
      const T along_n = c * (n2 * row[friction] + n3 * row[friction + 1]);
      row[slip_rate] = most * row[friction] - along_n * n2 + free2;
      row[slip_rate + 1] = most * row[friction + 1] - along_n * n3 + free3;
    }
  }

  /// What the forces move.
  template <class T>
  static constexpr void move(const std::array<T, states>& x, const std::array<T, parameters>& p,
                             const T& reach, std::array<T, rows>& row) {
    const T pace = 2.0 * x[s], &f = row[force], &y2 = row[friction], &y3 = row[friction + 1];
    const T &a1 = x[axis], &a2 = x[axis + 1], &a3 = x[axis + 2];
    const T lever = p[arm] * a1 - reach, axial = a2 * y3 - a3 * y2;
    row[velocity] = f / p[mass] - p[gravity] * pace;
    row[velocity + 1] = y2 / p[mass];
    row[velocity + 2] = y3 / p[mass];
    row[momentum] = p[arm] * axial;
    row[momentum + 1] = p[arm] * (a3 * f) - lever * y3;
    row[momentum + 2] = lever * y2 - p[arm] * (a2 * f);
    row[along] = reach * axial;
    row[roll] = pace * (p[twist] * x[along] + p[inverse] * swing_roll(x, p));
    if constexpr (!works) return;
    row[position] = pace * x[velocity + 1];
    row[position + 1] = pace * x[velocity + 2];
    if constexpr (grip != Grip::sticking) row[work + 2] = -(y2 * row[slip] + y3 * row[slip + 1]);
  }
  template <class T>
  static constexpr T swing_roll(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    const auto with_start = [&](int first) {
      return p[axis_start] * x[first] + p[axis_start + 1] * x[first + 1] + p[axis_start + 2] * x[first + 2];
    };
    return (x[along] + with_start(momentum)) / (1.0 + with_start(axis));
  }
};

}  // namespace mariotte::flow
