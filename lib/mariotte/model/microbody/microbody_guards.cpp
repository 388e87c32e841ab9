// What ends a phase of a microbody.
#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/simultaneous.hpp"
#include "mariotte/model/microbody/microbody_field.hpp"
#include "mariotte/model/microbody/microbody_phase.hpp"

namespace mariotte::model {

using flow::Crossing;
using flow::TipPhase;

/// A slip from rest starts at a rounding error of either sign; in space one that has sunk into noise is over.
double MicrobodyPhase::slip_margin(const TipMode& mode) const {
  if (mode.start != SlipStart::moving) return mechanics_.slip_noise;
  return body_.motion == TipPhase::Motion::spatial ? -mechanics_.slip_noise : 0;
}

/// Positive while the force has its sign; without adhesion of 1 − C_H ṅ.
double MicrobodyPhase::signed_pressure(const TipMotion& tip, Index i) const {
  const auto& law = body_.law[static_cast<std::size_t>(i)];
  return mode_.tip[i].force_sign * (law.adhesion > 0 ? contact::pressure(law, tip.indentation, tip.velocity)
                                                     : 1 - law.damping_hertz * tip.velocity);
}

double MicrobodyPhase::pressure_error(const TipMotion& tip, Index i) const {
  const auto& law = body_.law[static_cast<std::size_t>(i)];
  return flow::resolving_accuracy(*this, accuracy_, 64 * epsilon) *
         (law.adhesion > 0 ? contact::pressure_size(law, tip.indentation, body_.speed)
                           : 1 + law.damping_hertz * body_.speed);
}

/// Where a tip turns it rests for an instant only: it must be slow a natural time ahead, too.
/// Strong damping makes large forces of small errors of a speed. Where a body swings these are kept far below
/// its rest speed, so that they do not choose when it rests.
double MicrobodyPhase::unrest(ConstState x) const {
  if (!(mechanics_.well_energy(x) < 0)) return 1;
  const auto fastest = [&](ConstState at) {
    double speed = 0;
    for (Index i = 0; i < layout_.tips; ++i)
      if (x[layout_.place.gap[i]] < 0) speed = std::max(speed, std::abs(mechanics_.tip(at, i).velocity));
    return speed;
  };
  const double now = fastest(x) / tip_.rest_speed - 1;
  if (now > 0) return now;
  std::vector<double> ahead(x.begin(), x.end()), rate(x.size());
  derivative(x, rate);
  for (std::size_t k = 0; k < ahead.size(); ++k) ahead[k] += body_.time * rate[k];
  const double error = can_swing(body_) ? 0 : flow::resolving_accuracy(*this, accuracy_, 64 * epsilon);
  const double blurred = normal_damping_group() * error / body_.time;
  const double soon = (fastest(ahead) - blurred) / (2 * tip_.rest_speed) - 1;
  const double natural = body_.body.mass / (body_.time * body_.time);
  return std::max({now, soon, std::min(mechanics_.lifting_energy(x) / natural, imbalance(x, fastest(x)))});
}

/// Positive until the static forces on the tips of a swinging body balance to some per cent of the pull of
/// their wells, on the side of the well where more pull moves a tip out by a little only.
double MicrobodyPhase::imbalance(ConstState x, double speed) const {
  if (!can_swing(body_)) return infinity;
  double unstable = -1;
  for (Index i = 0; i < layout_.tips; ++i) {
    const double pulled_off = contact::rest_indentation(body_.law[static_cast<std::size_t>(i)]) / 3;
    if (const double gap = x[layout_.place.gap[i]]; gap < 0)
      unstable = std::max(unstable, 1 + gap / pulled_off);
  }
  return std::max(unstable, (1 + normal_damping_group()) * speed / (30 * tip_.rest_speed) - 1);
}

double MicrobodyPhase::guard(ConstState x, const TipForces& forces, Index i) const {
  if (crossings_[i] == Crossing::none || waiting_[i]) return 1;
  const Index tip = i / guards_per_tip;
  if (i == escape_guard(layout_.tips)) return clearance(mechanics_, x);
  if (i == rest_guard(layout_.tips)) return unrest(x);
  const auto& mode = mode_.tip[tip];
  const auto here = mechanics_.tip(x, tip);
  switch (static_cast<TipGuard>(i % guards_per_tip)) {
    case TipGuard::gap:
      return x[layout_.place.gap[tip]];
    case TipGuard::force:
      return signed_pressure(here, tip) + (doubtful_[tip] ? 2 * pressure_error(here, tip) : 0);
    case TipGuard::slip:
      return dot(here.slip, mode.direction) - mode.rest + slip_margin(mode);
    case TipGuard::cone:
      return mechanics_.holding(forces.normal[tip]) - norm(forces.friction[tip]);
    case TipGuard::turn_back:
      return here.velocity;
  }
  return 1;
}

void MicrobodyPhase::guards(ConstState x, State values) const {
  const auto forces = mechanics_.forces(x, mode_);
  for (Index i = 0; i < guard_count(); ++i) values[i] = guard(x, forces, i);
}

/// By differences along the trajectory; only the certificate and simultaneity need them, to some digits.
void MicrobodyPhase::guard_rates(ConstState x, ConstState dx, State rates) const {
  const double step = 1e-6 * time_scale_;
  std::vector<double> ahead(x.size()), behind(x.size()), before(rates.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    ahead[k] = x[k] + step * dx[k];
    behind[k] = x[k] - step * dx[k];
  }
  guards(ahead, rates);
  guards(behind, before);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = (rates[i] - before[i]) / (2 * step);
}

/// Slip from rest in space turns into its direction almost at once.
bool MicrobodyPhase::slip_turns() const {
  const auto starts = [](const TipMode& tip) {
    return tip.contact == TipContact::sliding && tip.start != SlipStart::moving;
  };
  return body_.motion == TipPhase::Motion::spatial && body_.friction.coefficient > 0 &&
         std::any_of(mode_.tip.begin(), mode_.tip.end(), starts);
}

}  // namespace mariotte::model
