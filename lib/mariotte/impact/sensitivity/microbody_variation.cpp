#include "mariotte/impact/sensitivity/microbody_variation.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/microbody/microbody_field.hpp"

namespace mariotte::impact {

using model::Mechanics;
using model::MicrobodyMode;
using model::TipContact;
using model::TipGuard;

namespace {

/// Any guard whose time follows from the body.
template <class T>
T guard_of(const Mechanics& mechanics, std::span<const T> x, const MicrobodyMode& mode, Index i) {
  using std::sqrt;
  if (i == model::escape_guard(mechanics.layout.tips)) return model::clearance(mechanics, x);
  const Index tip = i / model::guards_per_tip;
  const auto& state = mode.tip[static_cast<std::size_t>(tip)];
  const auto& body = mechanics.body;
  const auto& law = body.law[static_cast<std::size_t>(tip)];
  const model::MicrobodyField<T> field(mechanics, x);
  const auto& here = field.tip(tip);
  switch (static_cast<TipGuard>(i % model::guards_per_tip)) {
    case TipGuard::gap:
      return x[mechanics.layout.place.gap[tip]];
    case TipGuard::force:
      return law.adhesion > 0 ? state.force_sign * contact::pressure(law, here.indentation, here.velocity)
                              : state.force_sign * (1.0 - law.damping_hertz * here.velocity);
    case TipGuard::slip:
      return here.slip.e2 * state.direction.e2 + here.slip.e3 * state.direction.e3;
    case TipGuard::cone: {
      const auto forces = field.forces(mode);
      const auto& friction = forces.friction[tip];
      return contact::limit(body.friction, forces.normal[tip]) - sqrt(dot(friction, friction));
    }
    case TipGuard::turn_back:
      return here.velocity;
  }
  return T(1);
}

/// The only tip that sticks, if it has slid before.
std::optional<Index> stopped(const MicrobodyMode& before, const MicrobodyMode& after, Index tips) {
  std::optional<Index> found;
  for (Index i = 0; i < tips; ++i) {
    if (after.tip[i].contact != TipContact::sticking) continue;
    if (found || before.tip[i].contact != TipContact::sliding) return std::nullopt;
    found = i;
  }
  return found;
}

/// Friction that acts at once on a body, or on slopes of its state.
void push(std::span<double> x, const model::MicrobodyLayout& layout, double mass, const Vector3& lever,
          const Vector3& impulse) {
  const auto add = [&](Index at, const Vector3& part) {
    x[at] += part.e1;
    x[at + 1] += part.e2;
    x[at + 2] += part.e3;
  };
  add(layout.place.velocity, (1 / mass) * impulse);
  add(layout.place.momentum, cross(lever, impulse));
}

}  // namespace

MicrobodyVariation::MicrobodyVariation(const model::MicrobodySystem& system,
                                       const std::vector<ShiftedBodies>& shifted)
    : system_(system), shifted_(shifted), base_(system.body()) {
  base_.motion = flow::TipPhase::Motion::spatial;
  for (const auto& one : shifted) natural_.push_back(natural_slope(one.step));
}

std::vector<Index> MicrobodyVariation::places() const {
  const auto& place = system_.layout().place;
  std::vector<Index> list(place.gap.begin(), place.gap.begin() + system_.layout().tips);
  for (const Index i : {0, 1}) list.push_back(place.position + i);
  return list;
}

Mechanics MicrobodyVariation::mechanics(const model::DimensionlessMicrobody& body) const {
  return {body, system_.layout(), system_.mechanics().slip_noise, 0};
}

/// A slip that is no noise has a direction of its own.
MicrobodyMode MicrobodyVariation::sliding_freely(MicrobodyMode mode, ConstState x) const {
  for (Index i = 0; i < system_.layout().tips; ++i) {
    auto& tip = mode.tip[i];
    const bool slides = tip.contact == TipContact::sliding && tip.start != model::SlipStart::moving;
    if (slides && norm(system_.mechanics().tip(x, i).slip) > 1e-10 * base_.speed)
      tip.start = model::SlipStart::moving;
  }
  return mode;
}

void MicrobodyVariation::jacobian(const flow::Problem&, ConstState x, const MicrobodyMode& mode,
                                  State values) const {
  mechanics(base_).jacobian(x, sliding_freely(mode, x), values);
}

/// Tips that slide with friction.
std::vector<MicrobodyVariation::Slide> MicrobodyVariation::slides(ConstState x,
                                                                  const MicrobodyMode& mode) const {
  std::vector<Slide> list;
  const auto here = mechanics(base_);
  for (Index i = 0; i < system_.layout().tips; ++i) {
    const auto& tip = mode.tip[i];
    if (tip.contact != TipContact::sliding || base_.friction.coefficient == 0) continue;
    const auto motion = here.tip(x, i);
    const double size = norm(motion.slip);
    const bool turns = tip.start == model::SlipStart::moving && size > 0;
    list.push_back({i, turns ? size : infinity, turns ? (1 / size) * motion.slip : tip.direction,
                    here.normal_force(motion, i)});
  }
  return list;
}

/// The mode at all points of parameter c. Friction jumps where slip or normal force change their signs, which
/// the points may do before the body does: all points have the signs of the body.
std::array<MicrobodyMode, stencil.size()> MicrobodyVariation::modes_at(const MicrobodyMode& mode,
                                                                       const std::vector<Slide>& slides,
                                                                       ConstState x, Index c) const {
  std::array<MicrobodyMode, stencil.size()> result;
  result.fill(mode);
  for (const auto& [tip, slip, direction, force] : slides) {
    Vector3 slope;
    std::array<double, stencil.size()> sign;
    for (std::size_t k = 0; k < stencil.size(); ++k) {
      const auto there = mechanics(shifted_[c].at[k]);
      const auto motion = there.tip(x, tip);
      slope = slope + (stencil[k].weight / shifted_[c].step) * motion.slip;
      sign[k] = there.normal_force(motion, tip) * force < 0 ? -1 : 1;
    }
    const Vector3 turn = (1 / slip) * (slope - dot(slope, direction) * direction);
    for (std::size_t k = 0; k < stencil.size(); ++k) {
      result[k].tip[tip].direction = sign[k] * (direction + (stencil[k].offset * shifted_[c].step) * turn);
      result[k].tip[tip].start = model::SlipStart::turning;
    }
  }
  return result;
}

void MicrobodyVariation::source(ConstState x, const MicrobodyMode& mode, SlopeMatrix& b) const {
  const auto free = sliding_freely(mode, x);
  const auto sliding = slides(x, free);
  std::vector<double> dx(x.size());
  b.clear();
  for (Index c = 0; c < columns(); ++c) {
    const auto modes = modes_at(free, sliding, x, c);
    for (std::size_t k = 0; k < stencil.size(); ++k) {
      mechanics(shifted_[c].at[k]).derivative(x, modes[k], dx);
      const double weight = stencil[k].weight / shifted_[c].step;
      for (Index r = 0; r < b.rows; ++r) b(r, c) += weight * dx[r];
    }
  }
}

double MicrobodyVariation::cancellation(ConstState x, const MicrobodyMode& mode) const {
  if (system_.body().motion != flow::TipPhase::Motion::spatial || base_.friction.coefficient == 0) return 1;
  double least = base_.speed;
  for (Index i = 0; i < system_.layout().tips; ++i)
    if (mode.tip[i].contact == TipContact::sliding)
      least = std::min(least, std::max(norm(system_.mechanics().tip(x, i).slip), epsilon * base_.speed));
  return base_.speed / least;
}

double MicrobodyVariation::guard_rate(const flow::Problem&, Index i, ConstState x, ConstState dx,
                                      const MicrobodyMode& mode) const {
  using Number = series::Dual<double, 1>;
  if (!has_time(i, mode)) return 1;
  std::vector<Number> moved;
  for (std::size_t r = 0; r < x.size(); ++r) moved.push_back(Number(x[r], {dx[r]}));
  const Number value = guard_of<Number>(mechanics(base_), moved, mode, i);
  return value.slope[0];
}

void MicrobodyVariation::guard_slopes(Index i, ConstState x, const MicrobodyMode& mode,
                                      std::span<double> slopes) const {
  std::fill(slopes.begin(), slopes.end(), 0.0);
  if (!has_time(i, mode)) return;
  for (Index c = 0; c < columns(); ++c)
    slopes[c] = stencil_slope(shifted_[c].step, [&](std::size_t k) {
      return guard_of<double>(mechanics(shifted_[c].at[k]), x, mode, i);
    });
}

double MicrobodyVariation::crossing_speed(Index i, double rate, const MicrobodyMode&) const {
  if (i >= model::escape_guard(system_.layout().tips)) return 1;
  const auto& law = base_.law[static_cast<std::size_t>(i / model::guards_per_tip)];
  const double force = base_.body.mass * base_.speed / base_.time;
  switch (static_cast<TipGuard>(i % model::guards_per_tip)) {
    case TipGuard::gap:
      return std::abs(rate) / base_.speed;
    case TipGuard::force:
      return std::abs(rate) * base_.time / contact::pressure_size(law, 1, base_.speed);
    case TipGuard::cone:
      return std::abs(rate) * base_.time / force;
    case TipGuard::slip:
    case TipGuard::turn_back:
      return std::abs(rate) * base_.time / base_.speed;
  }
  return 1;
}

void MicrobodyVariation::remember(Index, const MicrobodyMode&, const MicrobodyMode& after, const SlopeMatrix&,
                                  ConstState, std::span<const double>) {
  if (system_.body().motion != flow::TipPhase::Motion::spatial || base_.friction.coefficient == 0) return;
  for (Index i = 0; i < system_.layout().tips; ++i)
    slips_from_rest_ |=
        after.tip[i].contact == TipContact::sliding && after.tip[i].start != model::SlipStart::moving;
}

void MicrobodyVariation::keep_opening(const Passage& event) {
  if (opening_ || event.before.tip[0].contact == TipContact::clear ||
      event.after.tip[0].contact != TipContact::clear)
    return;
  const auto gap = std::ranges::find(event.guard, model::guard_index(0, TipGuard::gap));
  const auto& time = event.time[gap - event.guard.begin()];
  opening_ = {event.now, {event.x.begin(), event.x.end()}, event.slopes, event.clock};
  for (Index c = 0; c < columns(); ++c) {
    opening_->time_slopes[c] += time[c];
    for (std::size_t r = 0; r < event.x.size(); ++r) opening_->slopes(r, c) += event.rate[r] * time[c];
  }
}

/// Along the slopes of the state to the digit: at the end of a contact they are so large that points beside
/// it would have let go.
Vector3 MicrobodyVariation::slip_slope(Index tip, ConstState x, std::span<const double> slopes,
                                       Index c) const {
  using Number = series::Dual<double, 1>;
  std::vector<Number> moved;
  for (std::size_t r = 0; r < x.size(); ++r) moved.push_back(Number(x[r], {slopes[r]}));
  const auto base = mechanics(base_);
  const model::MicrobodyField<Number> field(base, moved);
  const auto& slip = field.tip(tip).slip;
  Vector3 sum{0, slip.e2.slope[0], slip.e3.slope[0]};
  for (std::size_t k = 0; k < stencil.size(); ++k)
    sum = sum + (stencil[k].weight / shifted_[c].step) * mechanics(shifted_[c].at[k]).tip(x, tip).slip;
  return sum;
}

// Next to rest the direction of a slip is rounding. What slopes of it miss there is friction, an impulse that
// takes away what is left of the slopes of the slip.
void MicrobodyVariation::come_to_rest(const MicrobodyMode& before, const MicrobodyMode& after, ConstState x,
                                      SlopeMatrix& slopes) const {
  const auto tip = stopped(before, after, system_.layout().tips);
  if (!tip) return;
  const double mass = base_.body.mass;
  const auto here = mechanics(base_).tip(x, *tip);
  std::array<double, 4> mobility{};
  for (const Index along : {0, 1}) {
    std::vector<double> pushed(x.begin(), x.end());
    push(pushed, system_.layout(), mass, here.lever, {0, along == 0 ? mass : 0, along == 1 ? mass : 0});
    const Vector3 change = mechanics(base_).tip(pushed, *tip).slip - here.slip;
    mobility[2 * along] = change.e2;
    mobility[2 * along + 1] = change.e3;
  }
  for (Index c = 0; c < slopes.columns; ++c) {
    const Vector3 slip = slip_slope(*tip, x, slopes.column(c), c);
    std::array<double, 2> impulse{};
    model::hold(mobility, std::array{slip.e2, slip.e3}, impulse);
    push(slopes.column(c), system_.layout(), mass, here.lever, {0, mass * impulse[0], mass * impulse[1]});
  }
}

void MicrobodyVariation::see(const flow::Step& step, const MicrobodyMode& mode) const {
  if (system_.body().motion != flow::TipPhase::Motion::spatial || base_.friction.coefficient == 0) return;
  for (Index i = 0; i < system_.layout().tips; ++i)
    if (mode.tip[i].contact == TipContact::sliding)
      near_rest_.see(i, norm(system_.mechanics().tip(step.after, i).slip));
    else
      near_rest_.forget(i);
}

std::vector<Index> MicrobodyVariation::telling(const std::vector<Index>& fired, const MicrobodyMode& before,
                                               const MicrobodyMode& after) const {
  auto list = fired;
  for (Index i = 0; i < system_.layout().tips; ++i) {
    if (before.tip[i].contact == TipContact::clear || after.tip[i].contact != TipContact::clear) continue;
    std::erase_if(list, [&](Index guard) { return guard / model::guards_per_tip == i; });
    list.push_back(model::guard_index(i, TipGuard::gap));
  }
  return list;
}

void MicrobodyVariation::meet(Index i, const MicrobodyMode& mode, State x) const {
  if (has_root(i, mode)) x[system_.layout().place.gap[i / model::guards_per_tip]] = 0;
}

}  // namespace mariotte::impact
