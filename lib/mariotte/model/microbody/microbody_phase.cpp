#include "mariotte/model/microbody/microbody_phase.hpp"

#include <algorithm>
#include <cmath>

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

/// What waits to leave zero does so now.
bool leaves(auto& waiting, Index i, bool has_left) {
  const bool now = waiting[i] && has_left;
  if (now) waiting[i] = false;
  return now;
}

/// Slip below this is none: a hundredth of what may be wrong anyway.
double noise_of_slip(const DimensionlessMicrobody& body, double accuracy) {
  return std::max(0.01 * accuracy * body.speed, 256 * epsilon * std::max(body.speed, 1 / body.time));
}

/// Rounding of the friction that sticking needs, which comes from forces and accelerations of natural size.
double noise_of_force(const DimensionlessMicrobody& body) {
  return 64 * epsilon * body.body.mass * body.speed / body.time;
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
  tip_.held_weight = can_swing(body) ? 0 : body.body.mass * body.gravity;
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
  const bool sticks = tip.contact == TipContact::sticking;
  series_ = is_known(tip);
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
  bind_guards(i);
}

/// In space the series know no lever that sinks with a tip at rest, nor a slip from rest that begins with
/// the touch, where friction starts from zero as well.
bool MicrobodyPhase::is_known(const TipMode& tip) const {
  if (body_.motion != TipPhase::Motion::spatial || body_.friction.coefficient == 0) return true;
  const bool starts_or_stays = tip.contact == TipContact::sticking || tip.start != SlipStart::moving;
  return !(starts_or_stays && (tip_.indented || tip.at_touch));
}

/// The guards of tip i for its series.
void MicrobodyPhase::bind_guards(Index i) {
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

/// A well may make a body far faster than it came.
double MicrobodyPhase::swiftness(ConstState x) const {
  double most = 1;
  for (const Index first : {layout_.place.velocity, layout_.place.momentum})
    for (Index i = first; i < first + 3; ++i) most = std::max(most, std::abs(x[i]) / magnitudes_[i]);
  return most;
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
  bool rewatched = false;
  const auto forces = mechanics_.forces(x, mode_);
  for (Index i = 0; i < layout_.tips; ++i) {
    if (mode_.tip[i].contact == TipContact::clear) continue;
    const auto here = mechanics_.tip(x, i);
    const double limit = mechanics_.holding(forces.normal[i]);
    const bool holds = norm(forces.friction[i]) < (1 - 1e-9) * limit;
    rewatched = turn_with_slip(mode_.tip[i], here.slip) || rewatched;
    rewatched = leaves(waiting_, guard_index(i, TipGuard::turn_back), here.velocity > 0) || rewatched;
    rewatched = leaves(doubtful_, i, signed_pressure(here, i) > pressure_error(here, i)) || rewatched;
    rewatched = leaves(waiting_, guard_index(i, TipGuard::cone), holds) || rewatched;
  }
  return rewatched ? flow::Accepted::rewatched : flow::Accepted::unchanged;
}

/// Friction of a tip that slides in space turns with its slip from now on.
bool MicrobodyPhase::turn_with_slip(TipMode& tip, const Vector3& slip) const {
  const bool spatial = body_.motion == TipPhase::Motion::spatial;
  if (!spatial || tip.contact != TipContact::sliding || norm(slip) <= own_direction()) return false;
  tip.direction = (1 / norm(slip)) * slip;
  tip.rest = 0;
  tip.start = SlipStart::moving;
  return true;
}

}  // namespace mariotte::model
