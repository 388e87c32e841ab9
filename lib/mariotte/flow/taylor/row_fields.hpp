// The fields of contacts side by side; a number holds many contacts. With the rate of the clock g = dt/dσ
// and, in a row, the inverse masses u of the bodies to both sides:
//
//   λ = (k + l s) δ + (c + h δ) δ̇ − a
//   s = δᵖ                    1 where p = 0
//   f = s λ                   force
//   δ' = g δ̇
//   δ̇' = g (u_l f_left − (u_l + u_r) f + u_r f_right + drive)
//   p' = g f                  impulse
//   w' = g f δ̇                work
//
// What is not `curved`, for it is linear, open or has no depth yet, has the root of 1. Without damping the
// stiffness is in the strength and the couplings, λ = δ. Where λ/δ is without δ, as of k + h δ̇, it is the
// load, else λ is. Contacts that are linked in another way than in a
// row may stand in several numbers: who has all forces of an order gives the coefficients of δ̇ and of the
// clock.
#pragma once
#include <array>
#include <cmath>

namespace mariotte::flow::taylor {

/// Rows and parameters of all fields.
struct RowQuantities {
  enum { indentation, rate, impulse, work, clock, time, states, root = states, rows, stretch = rows };
  enum {
    stiffness,
    steepening,
    damping,
    stiffening,
    ring,
    power,
    curved,  ///< 1 where δᵖ has to be found, else 0
    level,   ///< 1 − curved
    free,    ///< 0 where δᵖ is the clock, else 1
    chosen,  ///< 1 − free
    from_left,
    from_right,
    own,
    drive,
    strength,  ///< of forces
    parameters
  };
};

/// Time, the clock dt = √δ_c dσ of a lane c, and time for any exponents.
enum class Pace { plain, landing, general };

/// What λ is made of: δ alone, with k δ + c δ̇, or with all terms; that with l only at a general pace.
enum class Terms { elastic, viscous, mixed };

/// Who knows the forces that accelerate a contact: its neighbours in the row, or the caller.
enum class Given { by_neighbours, from_outside };

/// Maps 0 and 1 give the value of the left and the right neighbour, map 2 that of lane c.
template <Pace pace, Terms terms, Given given>
struct RowField : RowQuantities {
  static constexpr bool has_stretch = pace == Pace::general && terms == Terms::mixed;
  static constexpr int rows = RowQuantities::rows + has_stretch;
  static constexpr bool is_uniform(int row) { return row == clock || row == time; }

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    std::array<T, rows> row{};
    row[root] = power_of_depth(x, p);
    if constexpr (has_stretch) row[stretch] = row[root] * x[indentation];
    const T force = paced(x, row[root] * load(x, p, row));
    row[indentation] = paced(x, x[rate]);
    if constexpr (given == Given::by_neighbours) {
      row[rate] = p[from_left] * map<0>(force) + p[from_right] * map<1>(force) - p[own] * force;
      row[rate] = row[rate] + (pace == Pace::landing ? T(p[drive] * x[clock]) : p[drive]);
      if constexpr (pace == Pace::landing) row[clock] = 0.5 * map<2>(x[rate]);
    }
    row[impulse] = p[strength] * force;
    if constexpr (terms != Terms::elastic) row[work] = p[strength] * (force * x[rate]);
    if constexpr (pace == Pace::landing) row[time] = x[clock];
    return row;
  }

  /// A rate in time as one in the clock.
  template <class T>
  static constexpr T paced(const std::array<T, states>& x, const T& a) {
    if constexpr (pace == Pace::landing)
      return a * x[clock];
    else
      return a;
  }

 private:
  template <class T>
  static constexpr T load(const std::array<T, states>& x, const std::array<T, parameters>& p,
                          const std::array<T, rows>& row) {
    if constexpr (terms == Terms::elastic) return x[indentation];
    if constexpr (terms == Terms::viscous) return p[stiffness] * x[indentation] + p[damping] * x[rate];
    const T elastic = p[stiffness] * x[indentation] - p[ring],
            damper = p[damping] * x[rate] + p[stiffening] * (x[indentation] * x[rate]);
    if constexpr (has_stretch) return elastic + p[steepening] * row[stretch] + damper;
    return elastic + damper;
  }
  template <class T>
  static constexpr T power_of_depth(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    using std::pow, std::sqrt;
    const T depth = p[curved] * x[indentation] + p[level];
    if constexpr (pace == Pace::general)
      return pow(depth, p[power]);
    else if constexpr (pace == Pace::landing)
      return p[free] * sqrt(depth) + p[chosen] * x[clock];
    else
      return sqrt(depth);
  }
};

/// Branches that are polynomials in u: with φ = dδ/du, u' = g δ̇/φ, and the clock g = φ of a lane.
struct WidthQuantities : RowQuantities {
  enum { width = states, width_states, growth = width_states, width_rows };
  enum {
    steepness,  ///< φ = steepness u³ − pull
    pull,
    push0,
    push1,
    push3,
    push4,
    push6,
    loss,
    owner,  ///< 1 where φ is the clock, else 0
    other,  ///< 1 − owner
    width_parameters
  };
};

/// The caller gives the coefficients of δ̇, as of linked contacts, and those of the clock from `growth` = φ'.
template <Pace pace>
struct WidthField : WidthQuantities {
  enum { states = width_states, rows = width_rows, parameters = width_parameters };
  static constexpr bool is_uniform(int row) { return row == clock || row == time; }

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    std::array<T, rows> row{};
    const T square = x[width] * x[width], cube = square * x[width], quick = square * x[rate];
    const T inner = p[push3] + p[push4] * x[width] + p[push6] * cube;
    const T force = p[push0] + x[width] * (p[push1] + square * inner) + p[loss] * quick;
    const T slope = p[steepness] * cube - p[pull];
    row[growth] = 3.0 * (p[steepness] * quick);
    if constexpr (pace == Pace::landing) {
      const T travel = x[rate] * x[clock], push = force * x[clock];
      row[indentation] = travel;
      row[width] = p[other] * (travel / (p[other] * slope + p[owner])) + p[owner] * x[rate];
      row[impulse] = push;
      row[work] = push * x[rate];
      row[time] = x[clock];
    } else {
      row[indentation] = x[rate];
      row[width] = x[rate] / slope;
      row[impulse] = force;
      row[work] = force * x[rate];
    }
    return row;
  }
};

/// Forces on cubic segments, beside those that are powers.
struct CurveQuantities : RowQuantities {
  enum { from = parameters, push0, push1, push2, push3, curve_parameters };
};

/// A lane has the numbers of a segment or of powers; the others are zero. The caller gives the coefficients
/// of δ̇ and of the clock, as of linked contacts.
template <Pace pace, Terms terms>
struct CurveField : CurveQuantities {
  using Powers = RowField<pace, terms, Given::from_outside>;
  enum { powers = parameters, parameters = curve_parameters, rows = Powers::rows };
  static constexpr bool is_uniform(int row) { return Powers::is_uniform(row); }

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>& p) {
    std::array<T, powers> of_powers;
    for (int i = 0; i < powers; ++i) of_powers[i] = p[i];
    auto row = Powers::rates(x, of_powers);
    const T depth = x[indentation] - p[from];
    const T force = p[push0] + depth * (p[push1] + depth * (p[push2] + depth * p[push3]));
    row[impulse] = row[impulse] + Powers::paced(x, force);
    return row;
  }
};

/// Contacts without force, moved from outside.
template <Pace pace>
struct StillField : RowQuantities {
  static constexpr bool is_uniform(int row) { return row == clock || row == time; }

  template <class T>
  static constexpr auto rates(const std::array<T, states>& x, const std::array<T, parameters>&) {
    std::array<T, rows> row{};
    row[indentation] = x[rate];
    if constexpr (pace != Pace::landing) return row;
    row[indentation] = x[clock] * x[rate];
    row[time] = x[clock];
    return row;
  }
};

}  // namespace mariotte::flow::taylor
