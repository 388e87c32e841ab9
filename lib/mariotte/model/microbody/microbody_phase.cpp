#include "mariotte/model/microbody/microbody_phase.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::model {

using flow::Crossing;
using flow::TipPhase;

namespace {

flow::SymmetricBody symmetric_part(const DimensionlessMicrobody& body) {
  flow::SymmetricBody part{.mass = body.body.mass,
                           .axial = body.body.inertia.e1,
                           .transverse = body.body.inertia.e2,
                           .arm = {},
                           .radius = {},
                           .gravity = body.gravity};
  for (std::size_t i = 0; i < body.tips(); ++i) {
    part.arm[i] = body.body.tips[i].centre.e1;
    part.radius[i] = body.body.tips[i].radius;
  }
  return part;
}

/// Slip below this is none: a hundredth of what may be wrong anyway.
double noise_of_slip(const DimensionlessMicrobody& body, double accuracy) {
  return std::max(0.01 * accuracy * body.speed, 256 * epsilon * std::max(body.speed, 1 / body.time));
}

/// Rounding of the friction that sticking needs, which comes from forces and accelerations of natural size.
double noise_of_force(const DimensionlessMicrobody& body) {
  return 64 * epsilon * body.body.mass * body.speed / body.time;
}

/// A body that may turn about a tip that adhesion holds. A sphere, or one that moves along the normal only,
/// comes to rest altogether.
bool can_swing(const DimensionlessMicrobody& body) {
  return body.motion != TipPhase::Motion::normal && !(body.body.tips[0].centre == Vector3{});
}

/// Speed along the normal that counts as rest in a well: half of what may be wrong, or, where the tip follows
/// a swing and so never rests, a share of the speed that the well gives. Where such a run ends depends on the
/// scene alone.
double rest_speed(const DimensionlessMicrobody& body, double accuracy) {
  constexpr double share = 1e-3;
  const auto& law = body.law[0];
  const double well = -contact::stored_energy(law, contact::rest_indentation(law));
  return can_swing(body) ? share * std::sqrt(2 * well / body.body.mass) : 0.5 * accuracy * body.speed;
}

}  // namespace

MicrobodyPhase::MicrobodyPhase(const DimensionlessMicrobody& body, const MicrobodyLayout& layout,
                               double accuracy, WatchedSigns watched)
    : body_(body),
      layout_(layout),
      accuracy_(accuracy),
      mechanics_{body, layout, noise_of_slip(body, accuracy), noise_of_force(body)},
      watched_(watched),
      magnitudes_(model::magnitudes(body, layout)),
      crossings_(rest_guard(layout.tips) + 1, Crossing::none),
      waiting_(crossings_.size()) {
  tip_.place = free_.place = layout.place;
  tip_.body = free_.body = symmetric_part(body);
  tip_.motion = body.motion;
  tip_.tangent = body.tangent;
  tip_.axis = body.axis;
  tip_.friction = body.friction.coefficient;
  tip_.indented = body.lever == Lever::indented;
  tip_.speed = body.speed;
  tip_.rest_speed = rest_speed(body, accuracy);
  tip_.slip_noise = mechanics_.slip_noise;
  tip_.force_noise = mechanics_.force_noise;
  tip_.force_scale = body.body.mass * body.speed / body.time;
  for (Index i = 0; i < layout.tips; ++i) free_.guard[i] = guard_index(i, TipGuard::gap);
}

void MicrobodyPhase::watch(Index i) {
  const auto& tip = mode_.tip[i];
  const auto& law = body_.law[static_cast<std::size_t>(i)];
  if (tip.contact == TipContact::clear) {
    crossing(i, TipGuard::gap) = Crossing::falling;
    return;
  }
  ++closed_;
  const bool frictional = body_.friction.coefficient > 0 && body_.motion != TipPhase::Motion::normal;
  crossing(i, TipGuard::gap) = Crossing::rising;
  if ((frictional || watched_.force_signs) && (law.adhesion > 0 || law.damping_hertz > 0))
    crossing(i, TipGuard::force) = Crossing::falling;
  if (frictional && tip.contact == TipContact::sliding) crossing(i, TipGuard::slip) = Crossing::falling;
  if (frictional && tip.contact == TipContact::sticking) crossing(i, TipGuard::cone) = Crossing::falling;
  if (!mode_.captured) crossing(i, TipGuard::turn_back) = Crossing::falling;
}

void MicrobodyPhase::bind(const MicrobodyMode& mode) {
  mode_ = mode;
  closed_ = 0;
  std::fill(crossings_.begin(), crossings_.end(), Crossing::none);
  std::fill(waiting_.begin(), waiting_.end(), false);
  doubtful_.fill(true);
  for (Index i = 0; i < layout_.tips; ++i) watch(i);
  // Symmetric bodies need it not: their flight is known to its end.
  if (closed_ == 0 && !body_.symmetric && body_.gravity <= 0)
    crossings_[escape_guard(layout_.tips)] = Crossing::rising;
  if (closed_ > 0 && body_.after_capture == AfterCapture::stop && !mode_.captured)
    crossings_.back() = Crossing::falling;
  // The cone of a tip that touches only just is a point, and a tip has to come up before it can turn back.
  for (Index i = 0; i < layout_.tips; ++i) {
    waiting_[guard_index(i, TipGuard::cone)] = mode_.tip[i].contact == TipContact::sticking;
    waiting_[guard_index(i, TipGuard::turn_back)] = true;
  }
  time_scale_ = body_.time;
  bind_series();
}

void MicrobodyPhase::bind_series() {
  const Index i = mode_.tip[0].contact == TipContact::clear ? 1 : 0;
  series_ = closed_ == 1 && body_.symmetric;
  if (!series_) return;
  const auto& tip = mode_.tip[i];
  const auto& law = body_.law[static_cast<std::size_t>(i)];
  const bool spatial = body_.motion == TipPhase::Motion::spatial,
             sticks = tip.contact == TipContact::sticking;
  const bool frictional = body_.friction.coefficient > 0;
  // In space the series know no lever that sinks with a tip at rest, nor a slip from rest that begins with
  // the touch, where friction starts from zero as well.
  const bool from_rest = !sticks && tip.start != SlipStart::moving;
  if (spatial && frictional && (sticks || from_rest) && (tip_.indented || tip.at_touch)) series_ = false;
  tip_.tip = i;
  tip_.stiffness = law.stiffness;
  tip_.adhesion = law.adhesion;
  tip_.damping_hertz = law.damping_hertz;
  tip_.damping_adhesion = law.damping_adhesion;
  tip_.force_sign = tip.force_sign;
  tip_.sticking = sticks;
  tip_.slip = static_cast<TipPhase::Slip>(tip.start);
  tip_.from_rest = tip.direction;
  tip_.direction = dot(tip.direction, body_.tangent) < 0 ? -1 : 1;
  const auto watched = [&](TipGuard guard) {
    return crossing(i, guard) == Crossing::none ? Index{-1} : guard_index(i, guard);
  };
  tip_.separation = watched(TipGuard::gap);
  tip_.force = watched(TipGuard::force);
  tip_.stop = watched(TipGuard::slip);
  tip_.cone = watched(TipGuard::cone);
  tip_.turn_back = watched(TipGuard::turn_back);
  tip_.rest = crossings_.back() == Crossing::none ? -1 : rest_guard(layout_.tips);
  tip_.other_tip = layout_.tips > 1 ? guard_index(1 - i, TipGuard::gap) : -1;
}

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

/// Where a tip turns it rests for an instant only: it must be slow a tenth of the natural time ahead, too.
/// Strong damping makes large forces of small errors of a speed. Where a body swings these are kept far below
/// its rest speed, so that they do not choose when it rests.
double MicrobodyPhase::unrest(ConstState x) const {
  if (!(mechanics_.stored(x) < 0)) return 1;
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
  for (std::size_t k = 0; k < ahead.size(); ++k) ahead[k] += 0.1 * body_.time * rate[k];
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

/// Height of the mass centre over the reach of its tips.
double MicrobodyPhase::clearance(ConstState x) const {
  const auto& first = body_.body.tips[0];
  double reach = 0;
  for (const auto& tip : body_.body.tips) reach = std::max(reach, norm(tip.centre) + tip.radius);
  const Vector3 d = rotate(quaternion_at(x, layout_.place.attitude), first.centre);
  return x[layout_.place.gap[0]] + first.radius - d.e1 - reach;
}

double MicrobodyPhase::guard(ConstState x, const TipForces& forces, Index i) const {
  if (crossings_[i] == Crossing::none || waiting_[i]) return 1;
  const Index tip = i / guards_per_tip;
  if (i == escape_guard(layout_.tips)) return clearance(x);
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

/// A slip that turns has no other bound.
double MicrobodyPhase::damping_group() const {
  return closed_ > 0 && slip_turns() ? infinity : normal_damping_group();
}

/// The damping of a contact is taken at its natural depth, 1.
double MicrobodyPhase::normal_damping_group() const {
  double damping = 0;
  for (Index i = 0; i < layout_.tips; ++i) {
    const auto& law = body_.law[static_cast<std::size_t>(i)];
    if (mode_.tip[i].contact != TipContact::clear)
      damping = std::max(damping, law.stiffness * law.damping_hertz + law.adhesion * law.damping_adhesion);
  }
  return damping * body_.time / body_.body.mass;
}

void MicrobodyPhase::second_derivative(ConstState, State ddx) const {
  std::fill(ddx.begin(), ddx.end(), 0.0);
}

/// Of a body that swings about its tip also what would, over the time D/v of a swing, change velocities by
/// the accuracy: friction turns with the sign of the load; and what would blur its rest. D is from the mass
/// centre to the tip.
double MicrobodyPhase::least_load(double accuracy) const {
  const double creeping = Problem::least_load(accuracy);
  if (!can_swing(body_)) return creeping;
  const double swing = norm(body_.body.tips[0].centre) / body_.speed;
  return std::min({creeping, accuracy * body_.time / swing, 0.01 * tip_.rest_speed * body_.time});
}

/// Slip that has grown so far has a direction of its own, in which friction turns with it. Earlier, rounding
/// of the slip would turn friction by more than the slip has turned; later, friction would lag.
double MicrobodyPhase::own_direction() const {
  return std::max(4 * mechanics_.slip_noise, 1e-10 * body_.speed);
}

flow::Accepted MicrobodyPhase::accept(ConstState x) {
  if (closed_ == 0) return flow::Accepted::unchanged;
  auto result = flow::Accepted::unchanged;
  const auto forces = mechanics_.forces(x, mode_);
  for (Index i = 0; i < layout_.tips; ++i) {
    auto& tip = mode_.tip[i];
    if (tip.contact == TipContact::clear) continue;
    const auto here = mechanics_.tip(x, i);
    const Vector3 slip = here.slip;
    const Index cone = guard_index(i, TipGuard::cone), back = guard_index(i, TipGuard::turn_back);
    const bool spatial = body_.motion == TipPhase::Motion::spatial;
    if (spatial && tip.contact == TipContact::sliding && norm(slip) > own_direction()) {
      tip.direction = (1 / norm(slip)) * slip;
      tip.rest = 0;
      tip.start = SlipStart::moving;
      result = flow::Accepted::rewatched;
    }
    if (waiting_[back] && here.velocity > 0) {
      waiting_[back] = false;
      result = flow::Accepted::rewatched;
    }
    if (doubtful_[i] && signed_pressure(here, i) > pressure_error(here, i)) {
      doubtful_[i] = false;
      result = flow::Accepted::rewatched;
    }
    const double limit = mechanics_.holding(forces.normal[i]);
    if (waiting_[cone] && norm(forces.friction[i]) < (1 - 1e-9) * limit) {
      waiting_[cone] = false;
      result = flow::Accepted::rewatched;
    }
  }
  return result;
}

}  // namespace mariotte::model
