#include "mariotte/flow/tip_series.hpp"

#include <utility>

namespace mariotte::flow {
namespace {

/// What needs the product P w.
bool is_damped(const TipPhase& phase) {
  return phase.damping_hertz > 0 || phase.damping_adhesion > 0;
}

/// Calls visit(k) for k = 0 … order, each a constant, so that the sums over j ≤ k are unrolled.
template <class Visit>
void each_order(int order, Visit&& visit) {
  [&]<int... k>(std::integer_sequence<int, k...>) {
    ((k <= order ? visit(std::integral_constant<int, k>()) : void()), ...);
  }
  (std::make_integer_sequence<int, most_order + 1>());
}

}  // namespace

template <class Order>
void TipRows::contact(const TipPhase& phase, Order k) {
  const double one = k == 0 ? 1 : 0;
  area[k] = square(s, k);
  rate[k] = is_damped(phase) ? product(area, w, k) : 0;
  pressure[k] = phase.stiffness * (area[k] - phase.damping_hertz * rate[k]) -
                phase.adhesion * (one + phase.damping_adhesion * w[k]);
  force[k] = 2 * product(area, pressure, k);
}

template <class Order>
void TipRows::advance(const TipPhase& phase, Order k) {
  const double share = 1.0 / (k + 1);
  s[k + 1] = -w[k] * share;
  time[k + 1] = 2 * s[k] * share;
  if (phase.place.work < 0) return;
  work[0][k + 1] = 2 * phase.stiffness * phase.damping_hertz * square(rate, k) * share;
  work[1][k + 1] = 2 * phase.adhesion * phase.damping_adhesion * product(rate, w, k) * share;
  work[2][k + 1] = 0;
}

void NormalSeries::expand(const TipPhase& phase, int order) {
  each_order(order, [&](auto k) {
    contact(phase, k);
    if (k == order) return;
    advance(phase, k);
    w[k + 1] = (force[k] / phase.body.mass - 2 * phase.body.gravity * s[k]) / (k + 1);
  });
}

template <class Order>
void PlanarSeries::stick(const TipPhase& phase, Order k) {
  const double inertia_of_body = phase.body.transverse;
  inertia[k] = square(lever, k) + (k == 0 ? inertia_of_body / phase.body.mass : 0);
  load[k] = product(lever, moment, k) + inertia_of_body * product(spin, lever_rate, k);
  double known = load[k];
  for (int j = 1; j <= k; ++j) known -= inertia[j] * friction[k - j];
  friction[k] = known / inertia[0];
}

template <class Order>
void PlanarSeries::step(const TipPhase& phase, int order, Order k) {
  const auto& body = phase.body;
  const double arm = body.arm[phase.tip];
  const double sliding = -phase.friction * phase.force_sign * phase.direction;
  rise[k] = rise_start * cosine[k] + run_start * sine[k];
  across[k] = arm * (run_start * cosine[k] - rise_start * sine[k]);
  w[k] = normal[k] + product(spin, across, k);
  contact(phase, k);
  lever[k] = arm * rise[k] + (phase.indented ? area[k] : 0) - (k == 0 ? body.radius[phase.tip] : 0);
  slip[k] = tangential[k] - product(spin, lever, k);
  turn[k] = 2 * product(s, spin, k);
  moment[k] = product(across, force, k);
  if (phase.sticking) {
    lever_rate[k] = product(turn, across, k) - (phase.indented ? 2 * product(s, w, k) : 0);
    stick(phase, k);
  } else {
    friction[k] = sliding * force[k];
  }
  if (k == order) return;
  const double share = 1.0 / (k + 1);
  advance(phase, k);
  normal[k + 1] = (force[k] / body.mass - 2 * body.gravity * s[k]) * share;
  tangential[k + 1] = friction[k] / body.mass * share;
  spin[k + 1] = (moment[k] - product(lever, friction, k)) / body.transverse * share;
  cosine[k + 1] = -product(turn, sine, k) * share;
  sine[k + 1] = product(turn, cosine, k) * share;
  angle[k + 1] = turn[k] * share;
  if (phase.place.work < 0) return;
  position[k + 1] = 2 * product(s, tangential, k) * share;
  if (!phase.sticking) work[2][k + 1] = -product(friction, slip, k) * share;
}

void PlanarSeries::expand(const TipPhase& phase, int order) {
  each_order(order, [&](auto k) { step(phase, order, k); });
}

template <class Order>
void SpatialSeries::kinematics(const TipPhase& phase, Order k) {
  const auto& body = phase.body;
  const double twist = 1 / body.axial - 1 / body.transverse, arm = body.arm[phase.tip];
  along[k] =
      product(momentum[0], axis[0], k) + product(momentum[1], axis[1], k) + product(momentum[2], axis[2], k);
  for (int i = 0; i < 3; ++i) {
    spin[i][k] = momentum[i][k] / body.transverse + twist * product(along, axis[i], k);
    lever[i][k] = arm * axis[i][k];
  }
  w[k] = velocity[0][k] + product(spin[1], lever[2], k) - product(spin[2], lever[1], k);
  contact(phase, k);
  lever[0][k] += (phase.indented ? area[k] : 0) - (k == 0 ? body.radius[phase.tip] : 0);
  slip[0][k] = velocity[1][k] + product(spin[2], lever[0], k) - product(spin[0], lever[2], k);
  slip[1][k] = velocity[2][k] + product(spin[0], lever[1], k) - product(spin[1], lever[0], k);
  for (int i = 0; i < 3; ++i) swing_[i][k] = 2 * product(s, momentum[i], k) / body.transverse;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, l = (i + 2) % 3;
    axis_rate[i][k] = product(swing_[j], axis[l], k) - product(swing_[l], axis[j], k);
  }
}

template <class Order>
void SpatialSeries::slide(const TipPhase& phase, Order k) {
  if (phase.friction == 0) {
    friction[0][k] = friction[1][k] = 0;
    return;
  }
  slip_square[k] = square(slip[0], k) + square(slip[1], k);
  if (k == 0) {
    slip_inverse[0] = 1 / std::sqrt(slip_square[0]);
  } else {
    // R z' = −½ R' z for z = R^{−1/2}
    double sum = 0;
    for (int j = 1; j <= k; ++j) sum += (k - 0.5 * j) * slip_square[j] * slip_inverse[k - j];
    slip_inverse[k] = -sum / (k * slip_square[0]);
  }
  for (int i = 0; i < 2; ++i) {
    direction[i][k] = product(slip[i], slip_inverse, k);
    friction[i][k] = -phase.friction * phase.force_sign * product(force, direction[i], k);
  }
}

template <class Order>
void SpatialSeries::respond(const TipPhase& phase, Order k) {
  const auto& body = phase.body;
  const double twist = 1 / body.axial - 1 / body.transverse, radius = body.radius[phase.tip];
  const double inverse = 1 / body.transverse, one = k == 0 ? 1 / body.mass : 0;
  const double high = square(lever[0], k), two = square(lever[1], k), three = square(lever[2], k);
  const double twisted = twist * radius * radius, arm = body.arm[phase.tip];
  mobility_22[k] = one + inverse * (high + three) + twisted * square(axis[2], k);
  mobility_33[k] = one + inverse * (high + two) + twisted * square(axis[1], k);
  mobility_23[k] = -inverse * product(lever[1], lever[2], k) - twisted * product(axis[1], axis[2], k);
  lever_force[k] = product(lever[0], force, k);
  for (int i = 0; i < 3; ++i) twist_[i][k] = twist * product(along, axis_rate[i], k);
  const auto& z = twist_;
  const auto& e = axis_rate;
  free[0][k] = product(z[2], lever[0], k) - product(z[0], lever[2], k) +
               arm * (product(spin[2], e[0], k) - product(spin[0], e[2], k)) -
               inverse * product(lever_force, lever[1], k);
  free[1][k] = product(z[0], lever[1], k) - product(z[1], lever[0], k) +
               arm * (product(spin[0], e[1], k) - product(spin[1], e[0], k)) -
               inverse * product(lever_force, lever[2], k);
}

template <class Order>
void SpatialSeries::stick(Order k) {
  double known_2 = -free[0][k], known_3 = -free[1][k];
  for (int j = 1; j <= k; ++j) {
    known_2 -= mobility_22[j] * friction[0][k - j] + mobility_23[j] * friction[1][k - j];
    known_3 -= mobility_23[j] * friction[0][k - j] + mobility_33[j] * friction[1][k - j];
  }
  const double determinant = mobility_22[0] * mobility_33[0] - mobility_23[0] * mobility_23[0];
  friction[0][k] = (mobility_33[0] * known_2 - mobility_23[0] * known_3) / determinant;
  friction[1][k] = (mobility_22[0] * known_3 - mobility_23[0] * known_2) / determinant;
}

/// With B = (k+1) ρ₁ + μ σ_F f₀ A₀ the unknowns satisfy B û_k + (k+1) ρ_{k+1} û₀ = known, 2 û₀·û_k = known.
template <class Order>
void SpatialSeries::slide_from_rest(const TipPhase& phase, Order k) {
  const double limit = phase.friction * phase.force_sign;
  grip_22[k] = limit * product(force, mobility_22, k);
  grip_23[k] = limit * product(force, mobility_23, k);
  grip_33[k] = limit * product(force, mobility_33, k);
  auto& [n2, n3] = direction;
  if (k == 0) {
    n2[0] = phase.from_rest.e2;
    n3[0] = phase.from_rest.e3;
    const double start = n2[0] * (free[0][0] - grip_22[0] * n2[0] - grip_23[0] * n3[0]) +
                         n3[0] * (free[1][0] - grip_23[0] * n2[0] - grip_33[0] * n3[0]);
    speed[0] = 0;
    speed[1] = phase.slip == TipPhase::Slip::breaking ? 0 : start;
  } else {
    double known_2 = free[0][k], known_3 = free[1][k], bend = 0;
    for (int j = 1; j <= k; ++j) {
      known_2 -= grip_22[j] * n2[k - j] + grip_23[j] * n3[k - j];
      known_3 -= grip_23[j] * n2[k - j] + grip_33[j] * n3[k - j];
    }
    for (int j = 2; j <= k; ++j) {
      known_2 -= (k + 1) * speed[j] * n2[k + 1 - j];
      known_3 -= (k + 1) * speed[j] * n3[k + 1 - j];
    }
    for (int j = 1; j < k; ++j) bend -= 0.5 * (n2[j] * n2[k - j] + n3[j] * n3[k - j]);
    // û_k = bend û₀ + across û₀⊥
    const double b22 = (k + 1) * speed[1] + grip_22[0], b33 = (k + 1) * speed[1] + grip_33[0];
    const double left_2 = known_2 - bend * (b22 * n2[0] + grip_23[0] * n3[0]);
    const double left_3 = known_3 - bend * (grip_23[0] * n2[0] + b33 * n3[0]);
    const double p2 = -n3[0], p3 = n2[0];
    const double bp2 = b22 * p2 + grip_23[0] * p3, bp3 = grip_23[0] * p2 + b33 * p3;
    const double across = (p2 * left_2 + p3 * left_3) / (p2 * bp2 + p3 * bp3);
    n2[k] = bend * n2[0] + across * p2;
    n3[k] = bend * n3[0] + across * p3;
    speed[k + 1] = (n2[0] * (left_2 - across * bp2) + n3[0] * (left_3 - across * bp3)) / (k + 1);
  }
  for (int i = 0; i < 2; ++i) friction[i][k] = -limit * product(force, direction[i], k);
}

template <class Order>
void SpatialSeries::move(const TipPhase& phase, Order k) {
  const auto& body = phase.body;
  const double share = 1.0 / (k + 1);
  advance(phase, k);
  const auto& [y2, y3] = friction;
  velocity[0][k + 1] = (force[k] / body.mass - 2 * body.gravity * s[k]) * share;
  velocity[1][k + 1] = y2[k] / body.mass * share;
  velocity[2][k + 1] = y3[k] / body.mass * share;
  momentum[0][k + 1] = (product(lever[1], y3, k) - product(lever[2], y2, k)) * share;
  momentum[1][k + 1] = (product(lever[2], force, k) - product(lever[0], y3, k)) * share;
  momentum[2][k + 1] = (product(lever[0], y2, k) - product(lever[1], force, k)) * share;
  for (int i = 0; i < 3; ++i) axis[i][k + 1] = axis_rate[i][k] * share;
  for (int i = 0; i < 3; ++i) turn_[i][k] = 2 * product(s, spin[i], k);
  const auto& z = turn_;
  const auto& q = attitude;
  const auto p = [&](const Row& a, const Row& b) { return product(a, b, k); };
  attitude[0][k + 1] = -0.5 * (p(z[0], q[1]) + p(z[1], q[2]) + p(z[2], q[3])) * share;
  attitude[1][k + 1] = 0.5 * (p(z[0], q[0]) + p(z[1], q[3]) - p(z[2], q[2])) * share;
  attitude[2][k + 1] = 0.5 * (p(z[1], q[0]) + p(z[2], q[1]) - p(z[0], q[3])) * share;
  attitude[3][k + 1] = 0.5 * (p(z[2], q[0]) + p(z[0], q[2]) - p(z[1], q[1])) * share;
  if (phase.place.work < 0) return;
  for (int i = 0; i < 2; ++i) position[i][k + 1] = 2 * product(s, velocity[i + 1], k) * share;
  if (!phase.sticking)
    work[2][k + 1] = -(product(friction[0], slip[0], k) + product(friction[1], slip[1], k)) * share;
}

void SpatialSeries::expand(const TipPhase& phase, int order) {
  const bool from_rest = phase.slip != TipPhase::Slip::moving && phase.friction > 0;
  each_order(order, [&](auto k) {
    kinematics(phase, k);
    if (phase.sticking || from_rest) respond(phase, k);
    if (phase.sticking)
      stick(k);
    else if (from_rest)
      slide_from_rest(phase, k);
    else
      slide(phase, k);
    if (k < order) move(phase, k);
  });
}

}  // namespace mariotte::flow
