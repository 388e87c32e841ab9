#include "mariotte/flow/taylor/tip_motion.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/state_vectors.hpp"
#include "mariotte/flow/roots/polynomial.hpp"

namespace mariotte::flow {
namespace {

double value(const PowerSeries& row, double tau, int order) {
  return horner({row.data(), static_cast<std::size_t>(order) + 1}, tau);
}

/// What every motion starts from.
template <class Series>
void load_contact(Series& series, const TipPhase& phase, ConstState x) {
  series.start[series.s] = std::sqrt(std::max(0.0, -x[phase.place.gap[phase.tip]]));
  auto& parameter = series.parameter;
  parameter[series.stiffness] = phase.stiffness;
  parameter[series.adhesion] = phase.adhesion;
  parameter[series.damping_hertz] = phase.damping_hertz;
  parameter[series.damping_adhesion] = phase.damping_adhesion;
  parameter[series.mass] = phase.body.mass;
  parameter[series.gravity] = phase.body.gravity;
}

/// What every motion that turns knows of its lever.
template <class Series>
void load_lever(Series& series, const TipPhase& phase) {
  series.parameter[series.arm] = phase.body.arm[phase.tip];
  series.parameter[series.radius] = phase.body.radius[phase.tip];
}

template <class Series>
void store_contact(const Series& series, const TipPhase& phase, double tau, int order, ConstState start,
                   State x) {
  std::copy(start.begin(), start.end(), x.begin());
  const double s = value(series[series.s], tau, order);
  x[phase.place.gap[phase.tip]] = -s * s;
  if (phase.place.work < 0) return;
  for (int i = 0; i < 3; ++i) x[phase.place.work + i] += value(series[series.work + i], tau, order);
}

/// The gap of the other tip, by the height of this one and the component of the axis along e1.
void store_other_gap(const TipPhase& phase, double axis, State x) {
  const Index other = phase.place.gap[1 - phase.tip];
  if (other < 0) return;
  const auto& body = phase.body;
  x[other] = x[phase.place.gap[phase.tip]] + body.radius[phase.tip] - body.radius[1 - phase.tip] +
             (body.arm[1 - phase.tip] - body.arm[phase.tip]) * axis;
}

/// Of indentation and speed and, if they are followed, of what damping and friction take, as the speed of the
/// mass that has it beside the natural speed.
template <class Series>
double contact_coefficient(const Series& series, const TipPhase& phase, int k) {
  double most = std::max(std::abs(series[series.s][k]), std::abs(series[series.w][k]));
  if (phase.place.work < 0) return most;
  for (int i = 0; i < 3; ++i)
    most = std::max(most, std::abs(series[series.work + i][k]) * phase.speed / phase.force_scale);
  return most;
}

/// The contact point rests: what its velocity is off zero by is an error of the steps before, and is taken
/// off, so that a slip that begins here is known to all its digits.
bool starts_from_rest(const TipPhase& phase) {
  return phase.friction > 0 && (phase.sticking || phase.slip != TipPhase::Slip::moving);
}

Quaternion attitude_at(const TipPhase& phase, ConstState x) {
  return quaternion_at(x, phase.place.attitude);
}

/// Rotation about an axis, up to its size: the half of an angle by its cosine and sine.
Quaternion turn(const Vector3& axis, double cosine, double sine) {
  const bool is_wide = cosine < 0;
  const double w = is_wide ? std::abs(sine) : 1 + cosine;
  const double half = is_wide ? std::copysign(1 - cosine, sine) : sine;
  return {w, half * axis.e1, half * axis.e2, half * axis.e3};
}

void store_attitude(const TipPhase& phase, const Quaternion& q, State x) {
  const auto unit = normalized(q);
  put(x, phase.place.attitude, unit);
  store_other_gap(phase, rotate(unit, {1, 0, 0}).e1, x);
}

}  // namespace

double coefficient(const NormalSeries& series, const TipPhase& phase, int k) {
  return contact_coefficient(series, phase, k);
}

double coefficient(const PlanarSeries& series, const TipPhase& phase, int k) {
  const double reach = std::abs(phase.body.arm[phase.tip]) + phase.body.radius[phase.tip];
  return std::max({contact_coefficient(series, phase, k), std::abs(series[series.tangential][k]),
                   reach * std::abs(series[series.spin][k])});
}

double coefficient(const SpatialSeries& series, const TipPhase& phase, int k) {
  const double reach = std::abs(phase.body.arm[phase.tip]) + phase.body.radius[phase.tip];
  const double inverse = series.parameter[series.inverse];
  double most = contact_coefficient(series, phase, k);
  for (int i = 0; i < 3; ++i)
    most = std::max({most, std::abs(series[series.velocity + i][k]),
                     reach * inverse * std::abs(series[series.momentum + i][k])});
  for (int i = 0; i < 2; ++i) most = std::max(most, reach * std::abs(series[series.spin + i][k]));
  return most;
}

void load(NormalSeries& series, const TipPhase& phase, ConstState x) {
  load_contact(series, phase, x);
  series.start[series.w] = x[phase.place.velocity];
}

void load(PlanarSeries& series, const TipPhase& phase, ConstState x) {
  load_contact(series, phase, x);
  load_lever(series, phase);
  const Vector3 v = vector_at(x, phase.place.velocity), h = vector_at(x, phase.place.momentum);
  const Vector3 axis = rotate(attitude_at(phase, x), {1, 0, 0});
  auto& start = series.start;
  auto& parameter = series.parameter;
  start[series.normal] = v.e1;
  start[series.tangential] = dot(v, phase.tangent);
  start[series.spin] = dot(h, phase.axis) / phase.body.transverse;
  start[series.cosine] = 1;
  parameter[series.inertia] = phase.body.transverse;
  parameter[series.sinking] = phase.indented;
  parameter[series.rise_start] = axis.e1;
  parameter[series.run_start] = dot(axis, phase.tangent);
  parameter[series.sliding] = -phase.friction * phase.force_sign * phase.direction;
  if (!starts_from_rest(phase)) return;
  const double sunk = phase.indented ? start[series.s] * start[series.s] : 0;
  const double lever = phase.body.arm[phase.tip] * axis.e1 + sunk - phase.body.radius[phase.tip];
  start[series.tangential] = start[series.spin] * lever;
}

void load(SpatialSeries& series, const TipPhase& phase, ConstState x) {
  load_contact(series, phase, x);
  load_lever(series, phase);
  const double inverse = 1 / phase.body.transverse, twist = 1 / phase.body.axial - inverse;
  const Vector3 axis = rotate(attitude_at(phase, x), {1, 0, 0}), h = vector_at(x, phase.place.momentum);
  put(series.start, series.velocity, vector_at(x, phase.place.velocity));
  put(series.start, series.momentum, h);
  put(series.start, series.axis, axis);
  series.start[series.along] = dot(h, axis);
  series.start[series.direction] = phase.from_rest.e2;
  series.start[series.direction + 1] = phase.from_rest.e3;
  put(series.parameter, series.axis_start, axis);
  series.parameter[series.inverse] = inverse;
  series.parameter[series.twist] = twist;
  series.parameter[series.limit] = phase.friction * phase.force_sign;
  if (!starts_from_rest(phase)) return;
  const Vector3 spin = inverse * h + twist * dot(h, axis) * axis;
  const Vector3 stuck =
      cross(phase.body.arm[phase.tip] * axis - phase.body.radius[phase.tip] * normal_axis, spin);
  series.start[series.velocity + 1] = stuck.e2;
  series.start[series.velocity + 2] = stuck.e3;
}

void store(const NormalSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x) {
  store_contact(series, phase, tau, order, start, x);
  x[phase.place.velocity] = value(series[series.w], tau, order);
  const Index other = phase.place.gap[1 - phase.tip];
  if (other >= 0) x[other] += x[phase.place.gap[phase.tip]] - start[phase.place.gap[phase.tip]];
}

void store(const PlanarSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x) {
  store_contact(series, phase, tau, order, start, x);
  const auto at = [&](int row) { return value(series[row], tau, order); };
  put(x, phase.place.velocity, at(series.normal) * normal_axis + at(series.tangential) * phase.tangent);
  put(x, phase.place.momentum, phase.body.transverse * at(series.spin) * phase.axis);
  if (phase.place.work >= 0) {
    x[phase.place.position] += at(series.position) * phase.tangent.e2;
    x[phase.place.position + 1] += at(series.position) * phase.tangent.e3;
  }
  store_attitude(phase, turn(phase.axis, at(series.cosine), at(series.sine)) * attitude_at(phase, start), x);
}

void store(const SpatialSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x) {
  store_contact(series, phase, tau, order, start, x);
  const auto at = [&](int row) { return value(series[row], tau, order); };
  for (int i = 0; i < 3; ++i) {
    x[phase.place.velocity + i] = at(series.velocity + i);
    x[phase.place.momentum + i] = at(series.momentum + i);
  }
  if (phase.place.work >= 0)
    for (int i = 0; i < 2; ++i) x[phase.place.position + i] += at(series.position + i);
  const Vector3 before = vector_at(series.start, series.axis);
  const Vector3 axis{at(series.axis), at(series.axis + 1), at(series.axis + 2)}, turn = cross(before, axis);
  const auto tilt = normalized({1 + dot(before, axis), turn.e1, turn.e2, turn.e3});
  store_attitude(phase, tilt * rotation(before, at(series.roll)) * attitude_at(phase, start), x);
}

}  // namespace mariotte::flow
