#include "mariotte/flow/taylor/tip_series.hpp"

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
  // in an order that waits least for w, then for P w
  pressure[k] = ((phase.stiffness * area[k] - phase.adhesion * one) -
                 (phase.adhesion * phase.damping_adhesion) * w[k]) -
                (phase.stiffness * phase.damping_hertz) * rate[k];
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
  const double inverse_mass = 1 / phase.body.mass;
  each_order(order, [&](auto k) {
    contact(phase, k);
    if (k == order) return;
    advance(phase, k);
    const double share = 1.0 / (k + 1);
    w[k + 1] = (inverse_mass * share) * force[k] - (2 * phase.body.gravity * share) * s[k];
  });
}

template <class Order>
void PlanarSeries::turn(const TipPhase& phase, Order k) {
  const double arm = phase.body.arm[phase.tip];
  rise[k] = rise_start * cosine[k] + run_start * sine[k];
  across[k] = arm * (run_start * cosine[k] - rise_start * sine[k]);
  spin_cosine[k] = product(spin, cosine, k);
  spin_sine[k] = product(spin, sine, k);
  w[k] = normal[k] + arm * (run_start * spin_cosine[k] - rise_start * spin_sine[k]);
  contact(phase, k);
  const double radius = phase.body.radius[phase.tip];
  lever[k] = arm * rise[k] + (phase.indented ? area[k] : 0) - (k == 0 ? radius : 0);
  slip[k] = tangential[k] - arm * (rise_start * spin_cosine[k] + run_start * spin_sine[k]) +
            radius * spin[k] - (phase.indented ? product(spin, area, k) : 0);
  if (k == 0) slip[0] = tangential[0] - spin[0] * lever[0];  // a slip at rest is zero to the last bit
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

/// Friction and d₂ f − ℓ₁ y.
template <class Order>
double PlanarSeries::torque(const TipPhase& phase, Order k) {
  if (phase.sticking) {
    moment[k] = product(across, force, k);
    stick(phase, k);
    return moment[k] - product(lever, friction, k);
  }
  const double sliding = -phase.friction * phase.force_sign * phase.direction;
  friction[k] = sliding * force[k];
  grip_lever[k] = across[k] - sliding * lever[k];
  return product(grip_lever, force, k);
}

template <class Order>
void PlanarSeries::step(const TipPhase& phase, int order, Order k) {
  const auto& body = phase.body;
  turn(phase, k);
  const double cosine_rate = -2 * product(s, spin_sine, k), sine_rate = 2 * product(s, spin_cosine, k);
  if (phase.sticking)
    lever_rate[k] = body.arm[phase.tip] * (rise_start * cosine_rate + run_start * sine_rate) -
                    (phase.indented ? 2 * product(s, w, k) : 0);
  const double moment_sum = torque(phase, k);
  if (k == order) return;
  const double share = 1.0 / (k + 1);
  advance(phase, k);
  const double by_mass = share / body.mass, by_inertia = share / body.transverse;
  normal[k + 1] = by_mass * force[k] - (2 * body.gravity * share) * s[k];
  tangential[k + 1] = by_mass * friction[k];
  spin[k + 1] = by_inertia * moment_sum;
  cosine[k + 1] = cosine_rate * share;
  sine[k + 1] = sine_rate * share;
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
  const double inverse = 1 / body.transverse, twist = 1 / body.axial - inverse;
  const double arm = body.arm[phase.tip], radius = body.radius[phase.tip];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, l = (i + 2) % 3;
    spin[i][k] = inverse * momentum[i][k] + twist * product(along, axis[i], k);
    swing[i][k] = inverse * (product(momentum[j], axis[l], k) - product(momentum[l], axis[j], k));
    lever[i][k] = arm * axis[i][k];
    axis_rate[i][k] = 2 * product(s, swing[i], k);
  }
  w[k] = velocity[0][k] + arm * swing[0][k];
  contact(phase, k);
  lever[0][k] += (phase.indented ? area[k] : 0) - (k == 0 ? radius : 0);
  slip[0][k] = velocity[1][k] + arm * swing[1][k] - radius * spin[2][k];
  slip[1][k] = velocity[2][k] + arm * swing[2][k] + radius * spin[1][k];
  if (!phase.indented) return;
  slip[0][k] += product(area, spin[2], k);
  slip[1][k] -= product(area, spin[1], k);
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
  grip[k] = product(force, slip_inverse, k);
  for (int i = 0; i < 2; ++i) friction[i][k] = -phase.friction * phase.force_sign * product(grip, slip[i], k);
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
void SpatialSeries::roll_on(const TipPhase& phase, Order k) {
  const double inverse = 1 / phase.body.transverse, twist = 1 / phase.body.axial - inverse;
  double known = along[k];
  alignment[k] = k == 0 ? 1 : 0;
  for (int i = 0; i < 3; ++i) {
    known += axis[i][0] * momentum[i][k];
    alignment[k] += axis[i][0] * axis[i][k];
  }
  for (int j = 1; j <= k; ++j) known -= alignment[j] * swing_roll[k - j];
  swing_roll[k] = known / alignment[0];
  roll_rate[k] = twist * along[k] + inverse * swing_roll[k];
  roll[k + 1] = 2 * product(s, roll_rate, k) / (k + 1);
}

template <class Order>
void SpatialSeries::move(const TipPhase& phase, Order k) {
  const auto& body = phase.body;
  const double share = 1.0 / (k + 1);
  advance(phase, k);
  const auto& [y2, y3] = friction;
  const double by_mass = share / body.mass;
  velocity[0][k + 1] = by_mass * force[k] - (2 * body.gravity * share) * s[k];
  velocity[1][k + 1] = by_mass * y2[k];
  velocity[2][k + 1] = by_mass * y3[k];
  axial_torque[k] = product(axis[1], y3, k) - product(axis[2], y2, k);
  momentum[0][k + 1] = body.arm[phase.tip] * axial_torque[k] * share;
  momentum[1][k + 1] = (product(lever[2], force, k) - product(lever[0], y3, k)) * share;
  momentum[2][k + 1] = (product(lever[0], y2, k) - product(lever[1], force, k)) * share;
  for (int i = 0; i < 3; ++i) axis[i][k + 1] = axis_rate[i][k] * share;
  along[k + 1] =
      (body.radius[phase.tip] * axial_torque[k] - (phase.indented ? product(area, axial_torque, k) : 0)) *
      share;
  roll_on(phase, k);
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
