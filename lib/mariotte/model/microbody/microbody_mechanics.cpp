#include "mariotte/model/microbody/microbody_mechanics.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mariotte/core/bracket.hpp"

namespace mariotte::model {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;

/// In the plane the direction is the mode's; in space the slip's own, bent smoothly where there is none.
Vector3 slip_direction(const DimensionlessMicrobody& body, const TipMode& mode, const Vector3& slip,
                       double noise) {
  if (body.motion != flow::TipPhase::Motion::spatial) return mode.direction;
  const double size = norm(slip);
  if (mode.start == SlipStart::moving) return size > 0 ? (1 / size) * slip : mode.direction;
  return (1 / std::hypot(size, noise)) * slip;
}

/// Two tips of a body that lies flat, to about 1e-5, share friction along the line between them in any way:
/// the least norm, to as many digits. A turn that such friction would have to stop needs so much of it that
/// no cone can hold it: the tips then cannot both stick. True of such a body.
bool regularise(Matrix& mobility) {
  Eigen::FullPivLU<Matrix> division(mobility);
  division.setThreshold(1e-10);
  mobility.diagonal().array() += 1e-12 * mobility.norm();
  return division.rank() < mobility.rows();
}

}  // namespace

Vector3 Mechanics::turned(ConstState x, const Vector3& moment) const {
  const auto q = quaternion_at(x, layout.place.attitude);
  const auto& inertia = body.body.inertia;
  const Vector3 m = rotate(conjugate(q), moment);
  return rotate(q, {m.e1 / inertia.e1, m.e2 / inertia.e2, m.e3 / inertia.e3});
}

Vector3 Mechanics::spin(ConstState x) const {
  return turned(x, vector_at(x, layout.place.momentum));
}

TipMotion Mechanics::tip(ConstState x, Index i) const {
  const auto& one = body.body.tips[static_cast<std::size_t>(i)];
  const Vector3 d = rotate(quaternion_at(x, layout.place.attitude), one.centre);
  const Vector3 v = vector_at(x, layout.place.velocity), w = spin(x);
  const double indentation = std::max(0.0, -x[layout.place.gap[i]]);
  const double depth = body.lever == Lever::radius ? one.radius : one.radius - indentation;
  const Vector3 lever = d - depth * normal_axis;
  return {.indentation = indentation,
          .velocity = (v + cross(w, d)).e1,
          .lever = lever,
          .slip = tangential(v + cross(w, lever))};
}

double Mechanics::normal_force(const TipMotion& tip, Index i) const {
  return contact::normal_force(body.law[static_cast<std::size_t>(i)], tip.indentation, tip.velocity).value;
}

Vector3 Mechanics::slip_acceleration(ConstState x, const TipForces& forces, Index i) const {
  Vector3 force, moment;
  for (Index j = 0; j < layout.tips; ++j) {
    const Vector3 one = forces.normal[j] * normal_axis + forces.friction[j];
    force = force + one;
    moment = moment + cross(tip(x, j).lever, one);
  }
  const auto here = tip(x, i);
  const Vector3 w = spin(x), h = vector_at(x, layout.place.momentum);
  // ω̇ = I⁻¹ (M − ω × H) in space axes; the lever turns with the body, its vertical part stays.
  const Vector3 d = rotate(quaternion_at(x, layout.place.attitude), body.body.tips[i].centre);
  const double sinking = body.lever == Lever::indented ? here.velocity : 0;
  const Vector3 lever_rate = cross(w, d) - sinking * normal_axis;
  return tangential((1 / body.body.mass) * force + cross(turned(x, moment - cross(w, h)), here.lever) +
                    cross(w, lever_rate));
}

TipForces Mechanics::forces(ConstState x, const MicrobodyMode& mode) const {
  TipForces result;
  std::array<Index, 2> stuck{};
  std::size_t count = 0;
  for (Index i = 0; i < layout.tips; ++i) {
    const auto& one = mode.tip[i];
    if (one.contact == TipContact::clear) continue;
    const auto here = tip(x, i);
    result.normal[i] = normal_force(here, i);
    if (body.friction.coefficient == 0) continue;
    if (one.contact == TipContact::sticking)
      stuck[count++] = i;
    else
      result.friction[i] =
          -contact::limit(body.friction, result.normal[i]) * slip_direction(body, one, here.slip, slip_noise);
  }
  if (count > 0) hold(x, {stuck.data(), count}, result);
  return result;
}

// u̇ = A T + b is linear in the friction T of the sticking tips; columns by unit forces.
void Mechanics::hold(ConstState x, std::span<const Index> stuck, TipForces& forces) const {
  const Index size = 2 * std::ssize(stuck);
  const auto acceleration = [&](const TipForces& trial) {
    Vector u(size);
    for (Index k = 0; k < size; k += 2) {
      const Vector3 one = slip_acceleration(x, trial, stuck[k / 2]);
      u[k] = one.e2;
      u[k + 1] = one.e3;
    }
    return u;
  };
  const Vector free = acceleration(forces);
  Matrix mobility(size, size);
  for (Index k = 0; k < size; ++k) {
    auto unit = forces;
    (k % 2 ? unit.friction[stuck[k / 2]].e3 : unit.friction[stuck[k / 2]].e2) = 1;
    mobility.col(k) = acceleration(unit) - free;
  }
  if (std::ssize(stuck) > 1) forces.redundant = regularise(mobility);
  const Vector needed = -mobility.partialPivLu().solve(free);
  for (Index k = 0; k < size; k += 2) forces.friction[stuck[k / 2]] = {0, needed[k], needed[k + 1]};
}

Vector3 Mechanics::slip_from_rest(ConstState x, const MicrobodyMode& mode, Index i) const {
  auto loose = mode;
  loose.tip[i].contact = TipContact::sliding;
  auto forces = this->forces(x, loose);
  const double limit = contact::limit(body.friction, forces.normal[i]);
  forces.friction[i] = {};
  const auto plane = [](const Vector3& v) { return Eigen::Vector2d(v.e2, v.e3); };
  const Eigen::Vector2d free = plane(slip_acceleration(x, forces, i));
  Eigen::Matrix2d grip;
  for (int k = 0; k < 2; ++k) {
    forces.friction[i] = k == 0 ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
    grip.col(k) = limit * (plane(slip_acceleration(x, forces, i)) - free);
  }
  // (μ |F_n| A + c) û = b for the c > 0 that makes û a unit vector
  const auto direction = [&](double c) -> Eigen::Vector2d {
    return (grip + c * Eigen::Matrix2d::Identity()).partialPivLu().solve(free);
  };
  const auto excess = [&](double c) { return direction(c).norm() - 1; };
  const double most = free.norm();
  const double least = limit > 0 ? 0 : most;
  const double c =
      limit > 0 ? locate_sign_change(excess, least, excess(least), most, excess(most), 0.0) : most;
  const Eigen::Vector2d unit = direction(c).normalized();
  return {0, unit[0], unit[1]};
}

void Mechanics::derivative(ConstState x, const MicrobodyMode& mode, State dx) const {
  const auto& place = layout.place;
  const auto forces = this->forces(x, mode);
  Vector3 force = -body.body.mass * body.gravity * normal_axis, moment, dissipated;
  for (Index i = 0; i < layout.tips; ++i) {
    const auto here = tip(x, i);
    const Vector3 one = forces.normal[i] * normal_axis + forces.friction[i];
    force = force + one;
    moment = moment + cross(here.lever, one);
    dx[place.gap[i]] = here.velocity;
    if (mode.tip[i].contact == TipContact::clear) continue;
    const auto& law = body.law[static_cast<std::size_t>(i)];
    dissipated = dissipated - Vector3{contact::hertz_damping_power(law, here.indentation, here.velocity),
                                      contact::adhesion_damping_power(law, here.indentation, here.velocity),
                                      dot(forces.friction[i], here.slip)};
  }
  const Vector3 v = vector_at(x, place.velocity);
  dx[place.position] = v.e2;
  dx[place.position + 1] = v.e3;
  put(dx, place.velocity, (1 / body.body.mass) * force);
  put(dx, place.attitude, quaternion_rate(quaternion_at(x, place.attitude), spin(x)));
  put(dx, place.momentum, moment);
  if (place.work >= 0) put(dx, place.work, dissipated);
}

double Mechanics::stored(ConstState x) const {
  double sum = 0;
  for (Index i = 0; i < layout.tips; ++i)
    sum += contact::stored_energy(body.law[static_cast<std::size_t>(i)], tip(x, i).indentation);
  return sum;
}

double Mechanics::lifting_energy(ConstState x) const {
  const auto& first = body.body.tips[0];
  const double reach = norm(first.centre) + first.radius;
  const double rest = stored(x) + 2 * body.body.mass * std::abs(body.gravity) * reach;
  if (!body.symmetric) return rest + kinetic(x);
  const double rise = x[layout.place.velocity];
  if (first.centre == Vector3{}) return rest + 0.5 * body.body.mass * rise * rise;
  const double own = dot(spin(x), rotate(quaternion_at(x, layout.place.attitude), {1, 0, 0}));
  return rest + kinetic(x) - 0.5 * body.body.inertia.e1 * own * own;
}

double Mechanics::kinetic(ConstState x) const {
  const Vector3 v = vector_at(x, layout.place.velocity);
  return 0.5 * (body.body.mass * dot(v, v) + dot(spin(x), vector_at(x, layout.place.momentum)));
}

}  // namespace mariotte::model
