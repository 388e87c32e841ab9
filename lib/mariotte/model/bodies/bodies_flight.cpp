// Free flight of bodies in closed form.
#include "mariotte/model/bodies/bodies_flight.hpp"

#include <algorithm>

#include "mariotte/flow/flight.hpp"
#include "mariotte/model/bodies/bodies_phase.hpp"

namespace mariotte::model {
namespace {

/// The turn since the start after time t.
void turn(const BodiesLayout<2>& at, const SettingBody<2>&, ConstState x, Index i, double t, State result) {
  result[at.turn(i)] = x[at.turn(i)] + t * x[at.momentum(i)];
}
void turn(const BodiesLayout<3>& at, const SettingBody<3>& body, ConstState x, Index i, double t,
          State result) {
  const Vector3 momentum = vector_at(x, at.momentum(i));
  const Quaternion q = quaternion_at(x, at.turn(i));
  if (norm(momentum) == 0) return;
  if (body.is_round) {
    const double rate = norm(momentum) / body.inertia[0];
    put<double>(result, at.turn(i), rotation((1 / norm(momentum)) * momentum, rate * t) * q);
    return;
  }
  const flow::SymmetricBody symmetric{.mass = body.mass,
                                      .axial = body.inertia[0],
                                      .transverse = body.inertia[1],
                                      .arm = {},
                                      .radius = {},
                                      .gravity = 0};
  const auto flown = flow::flown(q * body.attitude, momentum, symmetric, t);
  put<double>(result, at.turn(i), flown * conjugate(body.attitude));
}

}  // namespace

template <int D>
void fly(const BodiesSetting<D>& setting, const BodiesLayout<D>& at, ConstState x, Index i, double t,
         State result) {
  for (int k = 0; k < D; ++k) {
    const double g = setting.gravity[k], v = x[at.velocity(i) + k];
    result[at.shift(i) + k] = x[at.shift(i) + k] + t * (v + 0.5 * t * g);
    result[at.velocity(i) + k] = v + t * g;
  }
  turn(at, setting.body[i], x, i, t, result);
}

template <int D>
void BodiesPhase<D>::fly(ConstState x, double t, State result) const {
  std::copy(x.begin(), x.end(), result.begin());
  for (Index i = 0; i < layout_.bodies; ++i) model::fly(setting_, layout_, x, i, t, result);
  result[layout_.clock()] += t;
}

template void fly(const BodiesSetting<2>&, const BodiesLayout<2>&, ConstState, Index, double, State);
template void fly(const BodiesSetting<3>&, const BodiesLayout<3>&, ConstState, Index, double, State);
template void BodiesPhase<2>::fly(ConstState, double, State) const;
template void BodiesPhase<3>::fly(ConstState, double, State) const;

}  // namespace mariotte::model
