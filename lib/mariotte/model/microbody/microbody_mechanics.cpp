#include "mariotte/model/microbody/microbody_mechanics.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mariotte/core/bracket.hpp"
#include "mariotte/model/microbody/microbody_field.hpp"

namespace mariotte::model {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;

/// Two tips of a body that lies flat, to about 1e-5, share friction along the line between them in any way:
/// the least norm, to as many digits. A turn that such friction would have to stop needs so much of it that
/// no cone can hold it: the tips then cannot both stick. True of such a body.
bool regularise(Matrix& mobility) {
  Eigen::FullPivLU<Matrix> division(mobility);
  division.setThreshold(1e-10);
  mobility.diagonal().array() += 1e-12 * mobility.norm();
  return division.rank() < mobility.rows();
}

/// Of the slip of tip i under this friction there; what sticks elsewhere still does.
Eigen::Vector2d accelerated(const MicrobodyField<double>& field, const MicrobodyMode& mode, TipForces forces,
                            Index i, const Vector3& friction) {
  forces.friction[i] = friction;
  field.hold_still(mode, forces);
  const Vector3 u = field.slip_acceleration(forces, i);
  return {u.e2, u.e3};
}

/// Unit vector û with (G + c) û = b for some c > 0, where G is the grip of friction and b the acceleration
/// without it; along b if there is none.
Eigen::Vector2d along_itself(const Eigen::Vector2d& free, const Eigen::Matrix2d& grip, bool grips) {
  const auto direction = [&](double c) -> Eigen::Vector2d {
    return (grip + c * Eigen::Matrix2d::Identity()).partialPivLu().solve(free);
  };
  const auto excess = [&](double c) { return direction(c).norm() - 1; };
  const double most = free.norm();
  const double c = grips ? locate_sign_change(excess, 0.0, excess(0), most, excess(most), 0.0) : most;
  return direction(c).normalized();
}

}  // namespace

bool hold(std::span<const double> mobility, std::span<const double> free, std::span<double> friction) {
  const Index size = std::ssize(free);
  if (size == 2) {  // one tip
    const Eigen::Map<const Eigen::Matrix2d> one(mobility.data());
    Eigen::Map<Eigen::Vector2d>(friction.data()) =
        -(one.inverse() * Eigen::Map<const Eigen::Vector2d>(free.data()));
    return false;
  }
  Matrix matrix = Eigen::Map<const Matrix>(mobility.data(), size, size);
  const bool redundant = regularise(matrix);
  Eigen::Map<Vector>(friction.data(), size) =
      -matrix.partialPivLu().solve(Eigen::Map<const Vector>(free.data(), size));
  return redundant;
}

Vector3 Mechanics::spin(ConstState x) const {
  return MicrobodyField<double>(*this, x).spin();
}

TipMotion Mechanics::tip(ConstState x, Index i) const {
  return MicrobodyField<double>(*this, x).tip(i);
}

double Mechanics::normal_force(const TipMotion& tip, Index i) const {
  return contact::normal_force(body.law[static_cast<std::size_t>(i)], tip.indentation, tip.velocity);
}

TipForces Mechanics::forces(ConstState x, const MicrobodyMode& mode) const {
  return MicrobodyField<double>(*this, x).forces(mode);
}

Vector3 Mechanics::slip_from_rest(ConstState x, const MicrobodyMode& mode, Index i) const {
  auto loose = mode;
  loose.tip[i].contact = TipContact::sliding;
  const MicrobodyField<double> field(*this, x);
  const auto forces = field.forces(loose);
  const auto slip_rate = [&](const Vector3& friction) {
    return accelerated(field, loose, forces, i, friction);
  };
  const Eigen::Vector2d free = slip_rate({});
  const double limit = contact::limit(body.friction, forces.normal[i]);
  Eigen::Matrix2d grip;
  grip << limit * (slip_rate({0, 1, 0}) - free), limit * (slip_rate({0, 0, 1}) - free);
  const Eigen::Vector2d unit = along_itself(free, grip, limit > 0);
  return {0, unit[0], unit[1]};
}

void Mechanics::derivative(ConstState x, const MicrobodyMode& mode, State dx) const {
  MicrobodyField<double>(*this, x).rates(mode, dx);
}

double Mechanics::stored(ConstState x) const {
  double sum = 0;
  for (Index i = 0; i < layout.tips; ++i)
    sum +=
        contact::stored_energy(body.law[static_cast<std::size_t>(i)], std::max(0.0, -x[layout.place.gap[i]]));
  return sum;
}

double Mechanics::well_energy(ConstState x) const {
  double deepest = 0;
  for (Index i = 0; i < layout.tips; ++i) deepest = std::max(deepest, -x[layout.place.gap[i]]);
  return can_swing(body) ? stored(x) : stored(x) - body.body.mass * body.gravity * deepest;
}

double Mechanics::lifting_energy(ConstState x) const {
  const double rise = x[layout.place.velocity];
  if (!can_swing(body)) return well_energy(x) + 0.5 * body.body.mass * rise * rise;
  const auto& first = body.body.tips[0];
  const double reach = norm(first.centre) + first.radius;
  const double rest = well_energy(x) + 2 * body.body.mass * std::abs(body.gravity) * reach;
  if (!body.symmetric) return rest + kinetic(x);
  const double own = dot(spin(x), rotate(quaternion_at(x, layout.place.attitude), {1, 0, 0}));
  return rest + kinetic(x) - 0.5 * body.body.inertia.e1 * own * own;
}

double Mechanics::kinetic(ConstState x) const {
  const Vector3 v = vector_at(x, layout.place.velocity);
  return 0.5 * (body.body.mass * dot(v, v) + dot(spin(x), vector_at(x, layout.place.momentum)));
}

}  // namespace mariotte::model
