// The field of a microbody, written once: T is a number, or a value with slopes, which gives the Jacobian.
#pragma once
#include <array>

#include "mariotte/model/microbody/microbody_mechanics.hpp"
#include "mariotte/series/dual.hpp"

namespace mariotte::model {

/// Friction T of the tips that stick, where u̇ = A T + b is linear in it: T = −A⁻¹ b. A by columns.
/// True if other friction does as well; this is the least.
bool hold(std::span<const double> mobility, std::span<const double> free, std::span<double> friction);
/// The same with slopes: A T' = −b' − A' T.
template <int n>
bool hold(std::span<const series::Dual<double, n>> mobility, std::span<const series::Dual<double, n>> free,
          std::span<series::Dual<double, n>> friction) {
  std::array<double, 16> matrix;
  std::array<double, 4> right, left;
  const auto size = free.size();
  const auto solve = [&] {
    return hold({matrix.data(), size * size}, {right.data(), size}, {left.data(), size});
  };
  for (std::size_t k = 0; k < size * size; ++k) matrix[k] = mobility[k].value;
  for (std::size_t row = 0; row < size; ++row) right[row] = free[row].value;
  const bool redundant = solve();
  for (std::size_t row = 0; row < size; ++row) friction[row] = left[row];
  for (int i = 0; i < n; ++i) {
    for (std::size_t row = 0; row < size; ++row) {
      right[row] = free[row].slope[i];
      for (std::size_t k = 0; k < size; ++k)
        right[row] += mobility[k * size + row].slope[i] * friction[k].value;
    }
    solve();
    for (std::size_t row = 0; row < size; ++row) friction[row].slope[i] = left[row];
  }
  return redundant;
}

/// Height of the mass centre over the reach of its tips.
template <class T>
T clearance(const Mechanics& mechanics, std::span<const T> x) {
  const auto& body = mechanics.body.body;
  const auto& place = mechanics.layout.place;
  const auto& [centre, radius] = body.tips[0];
  const auto d =
      rotate(quaternion_at<T>(x, place.attitude), BasicVector3<T>{T(centre.e1), T(centre.e2), T(centre.e3)});
  return x[place.gap[0]] + radius - d.e1 - reach(body);
}

/// A body at one instant: what its tips, forces and rates follow from.
template <class T>
class MicrobodyField {
 public:
  using Vector = BasicVector3<T>;

  MicrobodyField(const Mechanics& mechanics, std::span<const T> x)
      : mechanics_(mechanics),
        attitude_(quaternion_at<T>(x, place().attitude)),
        velocity_(vector_at<T>(x, place().velocity)),
        momentum_(vector_at<T>(x, place().momentum)),
        spin_(turned(momentum_)) {
    for (Index i = 0; i < mechanics.layout.tips; ++i) set_tip(x[place().gap[i]], i);
  }

  const Vector& spin() const { return spin_; }
  const BasicTipMotion<T>& tip(Index i) const { return tip_[i]; }

  T normal_force(Index i) const {
    return contact::normal_force(law(i), tip_[i].indentation, tip_[i].velocity);
  }

  /// Slip acceleration of tip i under these forces.
  Vector slip_acceleration(const BasicTipForces<T>& forces, Index i) const {
    const auto [force, moment] = sums(forces);
    // ω̇ = I⁻¹ (M − ω × H) in space axes; the lever turns with the body, its vertical part stays.
    Vector lever_rate = cross(spin_, arm_[i]);
    if (body().lever == Lever::indented) lever_rate.e1 = lever_rate.e1 - tip_[i].velocity;
    return tangential(T(1 / body().body.mass) * force +
                      cross(turned(moment - cross(spin_, momentum_)), tip_[i].lever) +
                      cross(spin_, lever_rate));
  }

  /// Forces of a mode; a sticking tip gets the friction that keeps its slip constant.
  BasicTipForces<T> forces(const MicrobodyMode& mode) const {
    BasicTipForces<T> result;
    for (Index i = 0; i < mechanics_.layout.tips; ++i) {
      const auto& one = mode.tip[i];
      if (one.contact == TipContact::clear) continue;
      result.normal[i] = normal_force(i);
      if (body().friction.coefficient == 0 || one.contact == TipContact::sticking) continue;
      result.friction[i] =
          -contact::limit(body().friction, result.normal[i]) * slip_direction(one, tip_[i].slip);
    }
    hold_still(mode, result);
    return result;
  }

  /// Gives the tips that stick the friction that they need beside all other forces.
  void hold_still(const MicrobodyMode& mode, BasicTipForces<T>& forces) const {
    std::array<Index, 2> stuck{};
    std::size_t count = 0;
    if (body().friction.coefficient == 0) return;
    for (Index i = 0; i < mechanics_.layout.tips; ++i) {
      if (mode.tip[i].contact != TipContact::sticking) continue;
      forces.friction[i] = {};
      stuck[count++] = i;
    }
    if (count > 0) hold_still({stuck.data(), count}, forces);
  }

  /// Rates of the whole state.
  void rates(const MicrobodyMode& mode, std::span<T> dx) const {
    const auto forces = this->forces(mode);
    auto [force, moment] = sums(forces);
    force.e1 = force.e1 - body().body.mass * body().gravity;
    for (Index i = 0; i < mechanics_.layout.tips; ++i) dx[place().gap[i]] = tip_[i].velocity;
    dx[place().position] = velocity_.e2;
    dx[place().position + 1] = velocity_.e3;
    put<T>(dx, place().velocity, T(1 / body().body.mass) * force);
    put<T>(dx, place().attitude, quaternion_rate(attitude_, spin_));
    put<T>(dx, place().momentum, moment);
    if (place().work >= 0) put<T>(dx, place().work, dissipated(mode, forces));
  }

 private:
  struct Sums {
    Vector force, moment;
  };

  const DimensionlessMicrobody& body() const { return mechanics_.body; }
  const flow::BodyPlaces& place() const { return mechanics_.layout.place; }
  const contact::BrachDunn& law(Index i) const { return body().law[static_cast<std::size_t>(i)]; }
  static Vector lift(const Vector3& v) { return {v.e1, v.e2, v.e3}; }

  void set_tip(const T& gap, Index i) {
    const auto& one = body().body.tips[static_cast<std::size_t>(i)];
    arm_[i] = rotate(attitude_, lift(one.centre));
    const T indentation = series::value_of(gap) < 0 ? -gap : T(0);
    Vector lever = arm_[i];
    lever.e1 = lever.e1 - one.radius;
    if (body().lever == Lever::indented) lever.e1 = lever.e1 + indentation;
    tip_[i] = {.indentation = indentation,
               .velocity = (velocity_ + cross(spin_, arm_[i])).e1,
               .lever = lever,
               .slip = tangential(velocity_ + cross(spin_, lever))};
  }

  /// R I⁻¹ Rᵀ M.
  Vector turned(const Vector& moment) const {
    const auto& inertia = body().body.inertia;
    const Vector m = rotate(conjugate(attitude_), moment);
    return rotate(attitude_, {T(1 / inertia.e1) * m.e1, T(1 / inertia.e2) * m.e2, T(1 / inertia.e3) * m.e3});
  }

  /// In the plane, and while a slip from rest is still noise, the direction is the mode's; else the slip's
  /// own.
  Vector slip_direction(const TipMode& mode, const Vector& slip) const {
    using std::sqrt;
    const bool own = body().motion == flow::TipPhase::Motion::spatial && mode.start == SlipStart::moving;
    if (!own || !(dot(slip, slip) > 0.0)) return lift(mode.direction);
    return (1.0 / sqrt(dot(slip, slip))) * slip;
  }

  Sums sums(const BasicTipForces<T>& forces) const {
    Sums total;
    for (Index i = 0; i < mechanics_.layout.tips; ++i) {
      Vector one = forces.friction[i];
      one.e1 = one.e1 + forces.normal[i];
      total.force = total.force + one;
      total.moment = total.moment + cross(tip_[i].lever, one);
    }
    return total;
  }

  Vector dissipated(const MicrobodyMode& mode, const BasicTipForces<T>& forces) const {
    Vector power;
    for (Index i = 0; i < mechanics_.layout.tips; ++i) {
      if (mode.tip[i].contact == TipContact::clear) continue;
      const auto& here = tip_[i];
      power = power - Vector{contact::hertz_damping_power(law(i), here.indentation, here.velocity),
                             contact::adhesion_damping_power(law(i), here.indentation, here.velocity),
                             dot(forces.friction[i], here.slip)};
    }
    return power;
  }

  /// The columns of u̇ = A T + b are found by unit forces.
  void hold_still(std::span<const Index> stuck, BasicTipForces<T>& forces) const {
    const auto size = 2 * stuck.size();
    std::array<T, 4> free, friction;
    std::array<T, 16> mobility;
    const auto accelerate = [&](const BasicTipForces<T>& trial, T* u) {
      for (const Index i : stuck) {
        const Vector one = slip_acceleration(trial, i);
        *u++ = one.e2;
        *u++ = one.e3;
      }
    };
    accelerate(forces, free.data());
    for (std::size_t k = 0; k < size; ++k) {
      auto unit = forces;
      auto& push = unit.friction[stuck[k / 2]];
      (k % 2 ? push.e3 : push.e2) = T(1);
      accelerate(unit, mobility.data() + k * size);
      for (std::size_t row = 0; row < size; ++row)
        mobility[k * size + row] = mobility[k * size + row] - free[row];
    }
    forces.redundant = hold(std::span<const T>(mobility.data(), size * size), {free.data(), size},
                            std::span<T>(friction.data(), size));
    for (std::size_t k = 0; k < size; k += 2)
      forces.friction[stuck[k / 2]] = {T(0), friction[k], friction[k + 1]};
  }

  const Mechanics& mechanics_;
  BasicQuaternion<T> attitude_;
  Vector velocity_, momentum_, spin_;
  std::array<Vector, 2> arm_;  ///< from the mass centre to the tips' centres
  std::array<BasicTipMotion<T>, 2> tip_;
};

}  // namespace mariotte::model
