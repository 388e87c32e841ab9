#include "mariotte/impact/microbody/microbody_gate.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {
namespace {

using model::MicrobodySystem;

/// Height of the mass centre over the plane.
double height(const MicrobodySystem& system, ConstState x) {
  const auto& first = system.body().body.tips[0];
  const auto q = quaternion_at(x, system.layout().place.attitude);
  return x[system.layout().place.gap[0]] + first.radius - rotate(q, first.centre).e1;
}

/// Kinetic, stored and of gravity.
double energy(const MicrobodySystem& system, ConstState x) {
  const auto& body = system.body();
  const double lifted = body.gravity == 0 ? 0 : body.body.mass * body.gravity * height(system, x);
  return system.mechanics().kinetic(x) + system.mechanics().stored(x) + lifted;
}

/// What a contact exchanges: the kinetic energy of the mass at the speed that the well of adhesion gives.
double natural_energy(const MicrobodySystem& system, ConstState start) {
  const double speed = std::max(system.body().speed, 1 / system.body().time);
  return system.mechanics().kinetic(start) + 0.5 * system.body().body.mass * speed * speed;
}

double lowest_open_gap(const MicrobodySystem& system, ConstState x, const model::MicrobodyMode& mode) {
  double lowest = 0;
  for (Index i = 0; i < system.layout().tips; ++i)
    if (mode.tip[i].contact == model::TipContact::clear)
      lowest = std::min(lowest, x[system.layout().place.gap[i]]);
  return lowest;
}

double attitude_error(const MicrobodySystem& system, ConstState x) {
  const auto q = quaternion_at(x, system.layout().place.attitude);
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z) - 1;
}

}  // namespace

std::vector<Balance> balances(const MicrobodySystem& system, ConstState start, ConstState end,
                              const model::MicrobodyMode& mode) {
  const double slack = body_slack * system.accuracy();
  const bool finite = std::all_of(end.begin(), end.end(), [](double v) { return std::isfinite(v); });
  if (!finite) return {{"the final state", NAN, slack}};
  const auto& body = system.body();
  const double joule = body.scale.energy(), allowed = slack * natural_energy(system, start) * joule;
  const double gained = (energy(system, end) - energy(system, start)) * joule;
  const double length = std::max(body.speed * body.time, 1.0) * body.scale.length;
  std::vector<Balance> list = {
      {"energy, which cannot grow [J],", std::max(gained, 0.0), allowed},
      {"the gap of an open tip [m]", lowest_open_gap(system, end, mode) * body.scale.length, slack * length},
      {"the norm of the attitude", attitude_error(system, end), slack}};
  const Index work = system.layout().place.work;
  if (work < 0) return list;
  const double lost = (end[work] + end[work + 1] + end[work + 2]) * joule;
  list.push_back({"the energy balance [J]", gained + lost, allowed});
  const char* losses[] = {"the energy dissipated by Hertz damping, which is below 0 [J],",
                          "the energy dissipated by adhesion damping, which is below 0 [J],",
                          "the energy dissipated by friction, which is below 0 [J],"};
  for (Index i = 0; i < 3; ++i) list.push_back({losses[i], std::min(end[work + i] * joule, 0.0), allowed});
  return list;
}

}  // namespace mariotte::impact
