#include "mariotte/impact/sensitivity/bodies/bodies_variation.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {

using model::BodiesLayout;
using model::BodiesMode;
using model::ClosedContact;
using model::Friction;
using model::Sloped;
using model::SlotGuard;

namespace {

using model::slope_lanes;

/// A state whose slopes are zero.
void lift_state(ConstState x, std::vector<Sloped>& result) {
  result.assign(x.begin(), x.end());
}

bool has_spring_state(const model::Tangential& tangential, const ClosedContact& one) {
  return tangential.has_spring() && !one.slack && one.friction != Friction::none;
}

}  // namespace

template <int D>
BodiesVariation<D>::BodiesVariation(model::BodiesSystem<D>& system,
                                    const std::vector<ShiftedSettings<D>>& shifted)
    : system_(system),
      base_(system.setting()),
      setting_(sloped_settings(base_, shifted)),
      base_field_(base_) {
  for (const auto& one : shifted) natural_.push_back(natural_slope(one.step));
  for (const auto& one : setting_) field_.emplace_back(one);
  totals_.assign(system.setting().contact.size(), SlopeMatrix(BodiesLayout<D>::tangents + 4, columns()));
  faded_.assign(totals_.size(), 0);
  one_sided_.assign(natural_.size(), false);
}

/// Attitudes act through spheres that are not at mass centres, and through moments that are not equal; the
/// clock through planes.
template <int D>
std::vector<Index> BodiesVariation<D>::active(const BodiesMode& mode) const {
  const auto& setting = system_.setting();
  const BodiesLayout<D> at{.bodies = std::ssize(setting.body), .slots = 0};
  std::vector<Index> list;
  const auto add = [&](Index first, Index count) {
    for (Index k = 0; k < count; ++k) list.push_back(first + k);
  };
  for (Index i = 0; i < at.bodies; ++i) {
    add(at.shift(i), D);
    if (setting.body[i].has_arms || (D == 3 && !setting.body[i].is_round)) add(at.turn(i), at.attitude);
    add(at.velocity(i), D + model::turns(D));
  }
  if (!setting.plane_velocity.empty()) add(at.clock(), 1);
  for (const auto& one : mode.closed)
    if (has_spring_state(setting.contact[one.contact].tangential, one)) add(at.spring(one.slot), at.tangents);
  return list;
}

template <int D>
std::vector<flow::Entry> BodiesVariation<D>::pattern(const BodiesMode& mode) const {
  const Index rows = system_.problem(mode).size();
  std::vector<flow::Entry> entries;
  for (const Index column : active(mode))
    for (Index row = 0; row < rows; ++row) entries.push_back({row, column});
  return entries;
}

template <int D>
std::vector<Index> BodiesVariation<D>::places() const {
  const BodiesLayout<D> at{.bodies = std::ssize(system_.setting().body), .slots = 0};
  std::vector<Index> list;
  for (Index i = 0; i < at.bodies; ++i)
    for (Index row = at.shift(i); row < at.velocity(i); ++row) list.push_back(row);
  return list;
}

template <int D>
void BodiesVariation<D>::jacobian(const flow::Problem&, ConstState x, const BodiesMode& mode,
                                  State values) const {
  const auto list = active(mode);
  const Index rows = std::ssize(x), count = std::ssize(list);
  dx_.resize(x.size());
  for (Index first = 0; first < count; first += slope_lanes) {
    const Index some = std::min(slope_lanes, count - first);
    lift_state(x, x_);
    for (Index k = 0; k < some; ++k) x_[list[first + k]].slope[k] = 1;
    base_field_.evaluate(system_.layout(x), mode, std::span<const Sloped>(x_));
    base_field_.rates(mode, std::span<const Sloped>(x_), std::span<Sloped>(dx_));
    for (Index k = 0; k < some; ++k)
      for (Index row = 0; row < rows; ++row) values[(first + k) * rows + row] = dx_[row].slope[k];
  }
}

template <int D>
void BodiesVariation<D>::source(ConstState x, const BodiesMode& mode, SlopeMatrix& b) const {
  dx_.resize(x.size());
  lift_state(x, x_);
  for (Index c = 0; c < columns(); ++c) {
    if (c % slope_lanes == 0) {
      auto& field = field_[c / slope_lanes];
      field.evaluate(system_.layout(x), mode, std::span<const Sloped>(x_));
      field.rates(mode, std::span<const Sloped>(x_), std::span<Sloped>(dx_));
    }
    for (Index row = 0; row < b.rows; ++row) b(row, c) = dx_[row].slope[c % slope_lanes];
  }
}

template <int D>
typename BodiesVariation<D>::Field& BodiesVariation<D>::evaluate(Index first, const BodiesMode& mode,
                                                                 ConstState x,
                                                                 const SlopeMatrix& slopes) const {
  auto& field = field_[first / slope_lanes];
  lift_state(x, x_);
  for (Index c = first; c < std::min(first + slope_lanes, columns()); ++c)
    for (Index row = 0; row < slopes.rows; ++row) x_[row].slope[c - first] = slopes(row, c);
  field.evaluate(system_.layout(x), mode, std::span<const Sloped>(x_));
  return field;
}

template <int D>
Index BodiesVariation<D>::contact_of(Index i, const BodiesMode& mode) const {
  const auto& phase = system_.problem(mode);
  if (i >= phase.stray_guard(0)) return -1;
  if (i >= phase.parting_guard(0)) return mode.touching[i - phase.parting_guard(0)];
  if (i >= phase.gap_guard(0)) return phase.watched(i - phase.gap_guard(0));
  const auto one = std::find_if(mode.closed.begin(), mode.closed.end(), [&](const ClosedContact& closed) {
    return closed.slot == i / model::guards_per_slot;
  });
  return one->contact;
}

/// What touches at rest closes when a wave comes, and bodies that stray change nothing.
template <int D>
bool BodiesVariation<D>::has_time(Index i, const BodiesMode& mode) const {
  const Index contact = contact_of(i, mode);
  return contact >= 0 &&
         std::find(mode.touching.begin(), mode.touching.end(), contact) == mode.touching.end();
}

template <int D>
double BodiesVariation<D>::guard_rate(const flow::Problem& problem, Index i, ConstState x, ConstState dx,
                                      const BodiesMode&) const {
  std::vector<double> rates(problem.guard_count());
  problem.guard_rates(x, dx, rates);
  return rates[i];
}

template <int D>
void BodiesVariation<D>::guard_slopes(Index i, ConstState x, const BodiesMode& mode,
                                      std::span<double> slopes) const {
  const auto& phase = system_.problem(mode);
  guard_.resize(phase.guard_count());
  lift_state(x, x_);
  for (Index c = 0; c < columns(); ++c) {
    if (c % slope_lanes == 0) {
      auto& field = field_[c / slope_lanes];
      field.evaluate(phase.layout(), mode, std::span<const Sloped>(x_));
      phase.guards_of(field, std::span<Sloped>(guard_));
    }
    slopes[c] = guard_[i].slope[c % slope_lanes];
  }
}

template <int D>
bool BodiesVariation<D>::may_begin_steeply(const Mode& mode) const {
  return std::any_of(mode.closed.begin(), mode.closed.end(), [&](const model::ClosedContact& one) {
    const auto& contact = system_.setting().contact[one.contact];
    const auto friction = contact.tangential.law;
    return !contact::is_linear(contact.law) || friction == model::TangentialLaw::mindlin ||
           (D == 3 && friction != model::TangentialLaw::none);
  });
}

template <int D>
bool BodiesVariation<D>::has_root(Index i, const BodiesMode& mode) const {
  if (i >= system_.problem(mode).gap_guard(0)) return true;
  const auto guard = static_cast<SlotGuard>(i % model::guards_per_slot);
  if (guard != SlotGuard::open) return D == 3 && guard == SlotGuard::friction;
  return !contact::is_linear(system_.setting().contact[contact_of(i, mode)].law);
}

template <int D>
double BodiesVariation<D>::crossing_speed(Index i, double rate, const BodiesMode& mode) const {
  const auto& phase = system_.problem(mode);
  const auto& setting = system_.setting();
  const double relative = std::abs(rate) / setting.speed;
  if (i >= phase.gap_guard(0)) return relative;
  const auto& contact = setting.contact[contact_of(i, mode)];
  const auto& one = *std::find_if(mode.closed.begin(), mode.closed.end(), [&](const ClosedContact& closed) {
    return closed.slot == i / model::guards_per_slot;
  });
  switch (static_cast<SlotGuard>(i % model::guards_per_slot)) {
    case SlotGuard::friction:
      if (one.friction == Friction::stick) return std::abs(rate) * contact.time / contact.force;
      return relative * contact.time;
    case SlotGuard::load:
      return std::abs(rate) * contact.time / (contact.numbers.stiffness * contact.length);
    case SlotGuard::turn:
      return relative * contact.time;
    case SlotGuard::open:
    case SlotGuard::yield:
      break;
  }
  return relative;
}

template <int D>
std::string BodiesVariation<D>::name(Index i, const BodiesMode& mode) const {
  return "contact " + std::to_string(contact_of(i, mode) + 1);
}

template <int D>
std::vector<Index> BodiesVariation<D>::guards_at_start(const BodiesMode& mode, ConstState) const {
  std::vector<Index> guards;
  for (const auto& one : mode.closed) {
    auto open = mode;
    open_contact(open, one.contact);
    const auto& phase = system_.problem(open);
    guards.push_back(phase.gap_guard(phase.place_watched(one.contact)));
  }
  return guards;
}

template <int D>
void BodiesVariation<D>::open_contact(BodiesMode& mode, Index contact) const {
  const auto place = std::find_if(mode.closed.begin(), mode.closed.end(),
                                  [&](const ClosedContact& one) { return one.contact == contact; });
  mode.idle.push_back(place->slot);
  mode.closed.erase(place);
}

template <int D>
void BodiesVariation<D>::open_at_start(BodiesMode& mode, Index i) const {
  const auto& phase = system_.problem(mode);
  open_contact(mode, phase.watched(i - phase.gap_guard(0)));
}

template class BodiesVariation<2>;
template class BodiesVariation<3>;

}  // namespace mariotte::impact
