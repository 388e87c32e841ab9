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

}  // namespace

bool hold(std::span<const double> mobility, std::span<const double> free, std::span<double> friction) {
  const Index size = std::ssize(free);
  Matrix matrix = Eigen::Map<const Matrix>(mobility.data(), size, size);
  const bool redundant = size > 2 && regularise(matrix);
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
  auto forces = field.forces(loose);
  const double limit = contact::limit(body.friction, forces.normal[i]);
  forces.friction[i] = {};
  const auto plane = [](const Vector3& v) { return Eigen::Vector2d(v.e2, v.e3); };
  const Eigen::Vector2d free = plane(field.slip_acceleration(forces, i));
  Eigen::Matrix2d grip;
  for (int k = 0; k < 2; ++k) {
    forces.friction[i] = k == 0 ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
    grip.col(k) = limit * (plane(field.slip_acceleration(forces, i)) - free);
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
  MicrobodyField<double>(*this, x).rates(mode, dx);
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
