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

void load_contact(TipRows& rows, const TipPhase& phase, ConstState x) {
  rows.s[0] = std::sqrt(std::max(0.0, -x[phase.place.gap[phase.tip]]));
  rows.time[0] = 0;
  for (auto& work : rows.work) work[0] = 0;
}

void store_contact(const TipRows& rows, const TipPhase& phase, double tau, int order, ConstState start,
                   State x) {
  std::copy(start.begin(), start.end(), x.begin());
  const double s = value(rows.s, tau, order);
  x[phase.place.gap[phase.tip]] = -s * s;
  if (phase.place.work < 0) return;
  for (int i = 0; i < 3; ++i) x[phase.place.work + i] += value(rows.work[i], tau, order);
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
double contact_coefficient(const TipRows& rows, const TipPhase& phase, int k) {
  double most = std::max(std::abs(rows.s[k]), std::abs(rows.w[k]));
  if (phase.place.work < 0) return most;
  for (const auto& work : rows.work)
    most = std::max(most, std::abs(work[k]) * phase.speed / phase.force_scale);
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
  return std::max({contact_coefficient(series, phase, k), std::abs(series.tangential[k]),
                   reach * std::abs(series.spin[k])});
}

double coefficient(const SpatialSeries& series, const TipPhase& phase, int k) {
  const double reach = std::abs(phase.body.arm[phase.tip]) + phase.body.radius[phase.tip];
  double most = contact_coefficient(series, phase, k);
  for (int i = 0; i < 3; ++i)
    most = std::max({most, std::abs(series.velocity[i][k]), reach * std::abs(series.spin[i][k])});
  return most;
}

void load(NormalSeries& series, const TipPhase& phase, ConstState x) {
  load_contact(series, phase, x);
  series.w[0] = x[phase.place.velocity];
}

void load(PlanarSeries& series, const TipPhase& phase, ConstState x) {
  load_contact(series, phase, x);
  const Vector3 v = vector_at(x, phase.place.velocity), h = vector_at(x, phase.place.momentum);
  const Vector3 axis = rotate(attitude_at(phase, x), {1, 0, 0});
  series.normal[0] = v.e1;
  series.tangential[0] = dot(v, phase.tangent);
  series.spin[0] = dot(h, phase.axis) / phase.body.transverse;
  series.cosine[0] = 1;
  series.sine[0] = series.position[0] = 0;
  series.rise_start = axis.e1;
  series.run_start = dot(axis, phase.tangent);
  if (!starts_from_rest(phase)) return;
  const double sunk = phase.indented ? series.s[0] * series.s[0] : 0;
  const double lever = phase.body.arm[phase.tip] * axis.e1 + sunk - phase.body.radius[phase.tip];
  series.tangential[0] = series.spin[0] * lever;
}

void load(SpatialSeries& series, const TipPhase& phase, ConstState x) {
  load_contact(series, phase, x);
  const Vector3 axis = rotate(attitude_at(phase, x), {1, 0, 0});
  const double axes[3] = {axis.e1, axis.e2, axis.e3};
  for (int i = 0; i < 3; ++i) {
    series.velocity[i][0] = x[phase.place.velocity + i];
    series.momentum[i][0] = x[phase.place.momentum + i];
    series.axis[i][0] = axes[i];
  }
  const Vector3 h = vector_at(x, phase.place.momentum);
  series.along[0] = dot(h, axis);
  series.roll[0] = 0;
  for (auto& row : series.position) row[0] = 0;
  if (!starts_from_rest(phase)) return;
  const double inverse = 1 / phase.body.transverse;
  const Vector3 spin = inverse * h + (1 / phase.body.axial - inverse) * dot(h, axis) * axis;
  const Vector3 stuck =
      cross(phase.body.arm[phase.tip] * axis - phase.body.radius[phase.tip] * normal_axis, spin);
  series.velocity[1][0] = stuck.e2;
  series.velocity[2][0] = stuck.e3;
}

void store(const NormalSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x) {
  store_contact(series, phase, tau, order, start, x);
  x[phase.place.velocity] = value(series.w, tau, order);
  const Index other = phase.place.gap[1 - phase.tip];
  if (other >= 0) x[other] += x[phase.place.gap[phase.tip]] - start[phase.place.gap[phase.tip]];
}

void store(const PlanarSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x) {
  store_contact(series, phase, tau, order, start, x);
  const auto at = [&](const PowerSeries& row) { return value(row, tau, order); };
  put(x, phase.place.velocity, at(series.normal) * normal_axis + at(series.tangential) * phase.tangent);
  put(x, phase.place.momentum, phase.body.transverse * at(series.spin) * phase.axis);
  if (phase.place.work >= 0) {
    x[phase.place.position] += at(series.position) * phase.tangent.e2;
    x[phase.place.position + 1] += at(series.position) * phase.tangent.e3;
  }
  const double angle = std::atan2(at(series.sine), at(series.cosine));
  store_attitude(phase, rotation(phase.axis, angle) * attitude_at(phase, start), x);
}

void store(const SpatialSeries& series, const TipPhase& phase, double tau, int order, ConstState start,
           State x) {
  store_contact(series, phase, tau, order, start, x);
  const auto at = [&](const PowerSeries& row) { return value(row, tau, order); };
  for (int i = 0; i < 3; ++i) {
    x[phase.place.velocity + i] = at(series.velocity[i]);
    x[phase.place.momentum + i] = at(series.momentum[i]);
  }
  if (phase.place.work >= 0)
    for (int i = 0; i < 2; ++i) x[phase.place.position + i] += at(series.position[i]);
  const Vector3 before{series.axis[0][0], series.axis[1][0], series.axis[2][0]};
  const Vector3 axis{at(series.axis[0]), at(series.axis[1]), at(series.axis[2])}, turn = cross(before, axis);
  const auto tilt = normalized({1 + dot(before, axis), turn.e1, turn.e2, turn.e3});
  store_attitude(phase, tilt * rotation(before, at(series.roll)) * attitude_at(phase, start), x);
}

}  // namespace mariotte::flow
