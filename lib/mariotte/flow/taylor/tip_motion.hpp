// Between the state vector and the series of a tip: how each motion starts, what its errors and guards are,
// and where it ends.
#pragma once
#include <algorithm>

#include "mariotte/core/quaternion.hpp"
#include "mariotte/flow/taylor/tip_series.hpp"

namespace mariotte::flow {

/// Largest coefficient of order k among the quantities whose error matters, in units of velocity.
double coefficient(const NormalSeries& series, const TipPhase& phase, int k);
/// The same of a motion in a plane.
double coefficient(const PlanarSeries& series, const TipPhase& phase, int k);
/// The same of a motion in space.
double coefficient(const SpatialSeries& series, const TipPhase& phase, int k);

/// Coefficients of order 0 from the state.
void load(NormalSeries& series, const TipPhase& phase, ConstState x);
/// The same of a motion in a plane.
void load(PlanarSeries& series, const TipPhase& phase, ConstState x);
/// The same of a motion in space.
void load(SpatialSeries& series, const TipPhase& phase, ConstState x);

/// The state at τ, given that at τ = 0.
void store(const NormalSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x);
/// The same of a motion in a plane.
void store(const PlanarSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x);
/// The same of a motion in space.
void store(const SpatialSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x);

/// Calls visit(guard, row, size) for every guard of the phase except turning back; a guard fires where its
/// row falls through zero. `size` is what rounding of the row is relative to.
template <class Visit>
void each_guard(const NormalSeries& series, const TipPhase& phase, int order, Visit&& visit);
/// The same of a motion in a plane.
template <class Visit>
void each_guard(const PlanarSeries& series, const TipPhase& phase, int order, Visit&& visit);
/// The same of a motion in space.
template <class Visit>
void each_guard(const SpatialSeries& series, const TipPhase& phase, int order, Visit&& visit);

namespace detail {

/// The pressure without the signs of its terms, at the incident speed: what its errors are relative to.
template <class Series>
double pressure_size(const Series& series, const TipPhase& phase) {
  const double spring = phase.adhesion > 0 ? phase.stiffness * series[series.area][0] : 1;
  return spring * (1 + phase.damping_hertz * phase.speed) +
         phase.adhesion * (1 + phase.damping_adhesion * phase.speed);
}

/// Coefficient k of the pressure, positive while the force has its sign; without adhesion of 1 − c_H ṅ.
template <class Series>
double signed_pressure(const Series& series, const TipPhase& phase, int k) {
  return phase.force_sign * (phase.adhesion > 0 ? series[series.pressure][k]
                                                : (k == 0) - phase.damping_hertz * series[series.w][k]);
}

/// Separation is where s falls; the force changes sign with Q, without adhesion with 1 − c_H ṅ.
template <class Series, class Visit>
void contact_guards(const Series& series, const TipPhase& phase, int order, Visit&& visit) {
  visit(phase.separation, series[series.s], 0.0);
  if (phase.force < 0) return;
  PowerSeries force;
  for (int k = 0; k <= order; ++k) force[k] = signed_pressure(series, phase, k);
  force[0] += phase.force_doubt * pressure_size(series, phase);
  visit(phase.force, force, 0.0);
}

/// Coefficient k of the square of a row.
inline double square(const PowerSeries& row, int k) {
  double sum = 0;
  for (int j = 0; j <= k; ++j) sum += row[j] * row[k - j];
  return sum;
}

/// Sticking that needs no friction cannot break: a sphere's, an upright rod's.
inline bool is_zero(const PowerSeries& row, int order) {
  return std::all_of(row.begin(), row.begin() + order + 1, [](double c) { return c == 0; });
}

/// Gap of the other tip of the body: n − ... along the axis a₁, given by its coefficients.
template <class Series, class Visit>
void other_guard(const Series& series, const PowerSeries& axis, const TipPhase& phase, int order,
                 Visit&& visit) {
  if (phase.other_tip < 0) return;
  const auto& body = phase.body;
  const Index other = 1 - phase.tip;
  const double between = body.arm[other] - body.arm[phase.tip];
  PowerSeries gap;
  for (int k = 0; k <= order; ++k) gap[k] = between * axis[k] - series[series.area][k];
  gap[0] += body.radius[phase.tip] - body.radius[other];
  if (gap[0] < 0 && gap[1] > 0) gap[0] = 0;  // it has just opened, up to the accuracy of the steps before
  visit(phase.other_tip, gap, 0.0);
}

}  // namespace detail

template <class Visit>
void each_guard(const NormalSeries& series, const TipPhase& phase, int order, Visit&& visit) {
  detail::contact_guards(series, phase, order, visit);
}

template <class Visit>
void each_guard(const PlanarSeries& series, const TipPhase& phase, int order, Visit&& visit) {
  detail::contact_guards(series, phase, order, visit);
  detail::other_guard(series, series[series.rise], phase, order, visit);
  PowerSeries row;
  if (phase.stop >= 0) {
    for (int k = 0; k <= order; ++k) row[k] = phase.direction * series[series.slip][k];
    if (phase.slip != TipPhase::Slip::moving) row[0] = 0;
    if (phase.slip == TipPhase::Slip::breaking) row[1] = 0;
    visit(phase.stop, row, 0.0);
  }
  if (phase.cone < 0 || detail::is_zero(series[series.friction], order)) return;
  const double natural = 2 * series[series.s][0] * phase.force_scale;
  for (const double side : {1.0, -1.0}) {
    for (int k = 0; k <= order; ++k)
      row[k] = phase.friction * phase.force_sign * series[series.force][k] -
               side * series[series.friction][k] + 2 * phase.force_noise * series[series.s][k];
    visit(phase.cone, row, natural);
  }
}

template <class Visit>
void each_guard(const SpatialSeries& series, const TipPhase& phase, int order, Visit&& visit) {
  detail::contact_guards(series, phase, order, visit);
  detail::other_guard(series, series[series.axis], phase, order, visit);
  PowerSeries row;
  if (phase.stop >= 0) {
    const double start = std::hypot(series[series.slip][0], series[series.slip + 1][0]);
    const bool moving = phase.slip == TipPhase::Slip::moving;
    const double n2 = moving ? series[series.slip][0] / start : phase.from_rest.e2;
    const double n3 = moving ? series[series.slip + 1][0] / start : phase.from_rest.e3;
    for (int k = 0; k <= order; ++k) row[k] = n2 * series[series.slip][k] + n3 * series[series.slip + 1][k];
    row[0] = moving ? start - phase.slip_noise : 0;
    if (phase.slip == TipPhase::Slip::breaking) row[1] = 0;
    visit(phase.stop, row, 0.0);
  }
  if (phase.cone < 0) return;
  const double natural = 2 * series[series.s][0] * phase.force_scale;
  const auto &y2 = series[series.friction], &y3 = series[series.friction + 1];
  if (detail::is_zero(y2, order) && detail::is_zero(y3, order)) return;
  for (int k = 0; k <= order; ++k)
    row[k] = phase.friction * phase.friction * detail::square(series[series.force], k) -
             detail::square(y2, k) - detail::square(y3, k) +
             4 * phase.force_noise * phase.force_noise * series[series.area][k];
  visit(phase.cone, row,
        natural * (phase.friction * std::abs(series[series.force][0]) + std::hypot(y2[0], y3[0])));
}

}  // namespace mariotte::flow
