// What an event does to the slopes of bodies.
#include <algorithm>
#include <cmath>

#include "mariotte/impact/sensitivity/bodies/bodies_variation.hpp"
#include "mariotte/model/bodies/bodies_parting.hpp"

namespace mariotte::impact {

using model::BodiesLayout;
using model::BodiesMode;
using model::ClosedContact;
using model::Friction;
using model::Sloped;
using model::TangentialLaw;

namespace {

using model::slope_lanes;

/// Along e_z × n in the plane, a vector in space.
template <class T>
model::Vec<T, 1> along(const model::Vec<T, 2>& state, const model::Vec<T, 2>& normal) {
  return {{dot(state, across(normal))}};
}
template <class T>
model::Vec<T, 3> along(const model::Vec<T, 3>& state, const model::Vec<T, 3>&) {
  return state;
}

/// T, ξ or e of a contact behind an event, from the state before it: what transitions of friction set.
template <int D>
class SpringBehind {
 public:
  static constexpr int size = BodiesLayout<D>::tangents;
  using Field = typename BodiesVariation<D>::Field;
  using Result = model::Vec<Sloped, size>;

  SpringBehind(const Field& field, const BodiesPassage<D>& event, const BodiesLayout<D>& at,
               std::span<const Sloped> x)
      : field_(field), before_(event.before), at_(at), x_(x), after_(event.x_after) {}

  Result operator()(const ClosedContact& one) const {
    const auto& tangential = field_.setting().contact[one.contact].tangential;
    if (!tangential.has_spring() || one.slack || one.friction == Friction::none) return {};
    const Index place = place_of(before_, one.contact);
    const auto* was = place < 0 ? nullptr : &before_.closed[place];
    const bool acted = was && !was->slack && was->friction != Friction::none;
    if (one.friction == Friction::slip) return slipping(one, acted ? was : nullptr, place);
    return acted ? sticking(one, *was, place) : held(one);
  }

 private:
  Result kept(const ClosedContact& one) const { return model::vec_at<size>(x_, at_.spring(one.slot)); }

  Result slipping(const ClosedContact& one, const ClosedContact* was, Index place) const {
    if constexpr (D == 2) {
      return {};
    } else {
      if (was && was->friction == Friction::slip) return kept(one);
      const auto& way = was ? field_.contact(place).friction : field_.motion(one.contact).slip;
      return Sloped((was ? -1.0 : 1.0) / norm(way)) * way;
    }
  }

  Result sticking(const ClosedContact& one, const ClosedContact& was, Index place) const {
    const auto& tangential = field_.setting().contact[one.contact].tangential;
    const auto& c = field_.contact(place);
    const bool grows = tangential.law == TangentialLaw::mindlin;
    if (was.friction == Friction::slip) {
      const bool as_force = grows && !one.unloading;
      const Sloped cap = tangential.friction * c.normal;
      return along((as_force ? cap : cap / c.spring) * c.direction, c.motion.normal);
    }
    if (!grows || was.unloading == one.unloading) return kept(one);
    return (one.unloading ? 1.0 / c.spring : c.spring) * kept(one);
  }

  /// What has been pushed for a little time when it is noticed has slipped since.
  Result held(const ClosedContact& one) const {
    const auto now = field_.motion(one.contact);
    const auto way = along(now.slip, now.normal);
    const auto stretch = model::vec_at<size>(after_, at_.spring(one.slot));
    double square = 0, product = 0;
    for (int k = 0; k < size; ++k) {
      square += way[k].value * way[k].value;
      product += way[k].value * stretch[k];
    }
    return square > 0 ? Sloped(product / square) * way : Result{};
  }

  const Field& field_;
  const BodiesMode& before_;
  const BodiesLayout<D>& at_;
  std::span<const Sloped> x_;
  ConstState after_;
};

}  // namespace

template <int D>
std::vector<Index> BodiesVariation<D>::telling(const std::vector<Index>& fired, const BodiesMode& before,
                                               const BodiesMode& after) const {
  const auto& phase = system_.problem(before);
  std::vector<Index> list;
  for (Index guard : fired) {
    const bool is_slot = guard < phase.gap_guard(0);
    if (is_slot && place_of(after, contact_of(guard, before)) < 0)
      guard = phase.slot_guard(guard / model::guards_per_slot, model::SlotGuard::open);
    if (std::find(list.begin(), list.end(), guard) == list.end()) list.push_back(guard);
  }
  // Bodies that stray, or have flown apart, change nothing: they tell a time only where nothing else does.
  const auto is_of_contact = [&](Index guard) { return contact_of(guard, before) >= 0; };
  if (std::any_of(list.begin(), list.end(), is_of_contact))
    std::erase_if(list, [&](Index guard) { return !is_of_contact(guard); });
  if (list.empty())  // a phase that could not go on to the end of a contact
    for (const auto& one : before.closed)
      if (place_of(after, one.contact) < 0)
        list.push_back(phase.slot_guard(one.slot, model::SlotGuard::open));
  return list;
}

/// Slopes of the time at which a contact is changed: by its own guard if that has fired.
template <int D>
const std::vector<double>& BodiesVariation<D>::time_of(const BodiesPassage<D>& event, Index contact) const {
  for (std::size_t k = 0; k < event.guard.size(); ++k)
    if (contact_of(event.guard[k], event.before) == contact) return event.time[k];
  return event.time[0];
}

/// What is integrated along a contact that opens.
template <int D>
void BodiesVariation<D>::keep_totals(const BodiesPassage<D>& event, const SlopeMatrix& slopes) {
  const auto at = system_.layout(event.x_before);
  for (const auto& one : event.before.closed) {
    if (place_of(event.after, one.contact) >= 0) continue;
    auto& totals = totals_[one.contact];
    const auto& time = time_of(event, one.contact);
    for (Index c = 0; c < columns(); ++c)
      for (Index k = 0; k < totals.rows; ++k) {
        const Index row = at.normal(one.slot) + k;
        totals(k, c) += slopes(row, c) + event.rate_before[row] * time[c];
      }
  }
}

/// What a spring loses on unloading grows like the inverse root of the depth at which it lets go. Its slopes
/// at fixed time and those of that time are so large that they cancel, to the digits which that depth has
/// left. Measured by differences of runs with friction from 0.3 to 10⁵.
template <int D>
void BodiesVariation<D>::see_fading(const BodiesPassage<D>& event) {
  constexpr double share = 0.5, steps_in_rounding = 4096;
  const auto at = system_.layout(event.x_before);
  for (const auto& one : event.before.closed) {
    const Index after = place_of(event.after, one.contact);
    const bool lets_go = after < 0 || event.after.closed[after].friction != Friction::stick;
    if (!model::fades(base_, one) || one.friction != Friction::stick || !lets_go) continue;
    const auto& contact = base_.contact[one.contact];
    const double depth = -gap_motion(base_, at, contact, event.x_before).gap;
    const double noise = gap_rounding(base_, at, contact, event.x_before) / steps_in_rounding;
    const double error = share * noise / depth * std::sqrt(base_.length / depth);
    faded_[one.contact] = std::max(faded_[one.contact], after < 0 || !(depth > 0) ? infinity : error);
  }
}

/// A slot that goes on, or begins at zero.
template <int D>
void BodiesVariation<D>::pass_slot(const BodiesPassage<D>& event, const ClosedContact& one,
                                   const SlopeMatrix& slopes, SlopeMatrix& result) {
  const auto at = system_.layout(event.x_before);
  const auto& time = time_of(event, one.contact);
  const bool goes_on = place_of(event.before, one.contact) >= 0;
  const auto met = [&](Index row, Index c) { return slopes(row, c) + event.rate_before[row] * time[c]; };
  const Index first = at.spring(one.slot), own = first + at.tangents, last = first + at.slot_size;
  x_.assign(event.x_before.begin(), event.x_before.end());
  typename SpringBehind<D>::Result spring;
  for (Index c = 0; c < columns(); ++c) {
    if (c % slope_lanes == 0) {
      for (Index k = 0; k < std::min(slope_lanes, columns() - c); ++k)
        for (Index row = 0; row < slopes.rows; ++row) x_[row].slope[k] = met(row, c + k);
      auto& field = field_[c / slope_lanes];
      field.evaluate(at, event.before, std::span<const Sloped>(x_));
      spring = SpringBehind<D>(field, event, at, x_)(one);
    }
    for (Index row = first; row < own; ++row)
      result(row, c) = spring[static_cast<int>(row - first)].slope[c % slope_lanes];
    for (Index row = own; row < last; ++row) result(row, c) = goes_on ? met(row, c) : 0;
    for (Index row = first; row < last; ++row) result(row, c) -= event.rate_after[row] * time[c];
  }
}

/// Displacements have lost digits of the gap where a contact closes. What follows begins at zero to the last
/// bit, as forces have roots there.
template <int D>
void BodiesVariation<D>::begin_at_zero(const BodiesPassage<D>& event) {
  const auto at = system_.layout(event.x_after);
  for (const auto& one : event.after.closed) {
    if (place_of(event.before, one.contact) >= 0) continue;
    auto& gap = base_.contact[one.contact].gap;
    gap -= gap_motion(base_, at, base_.contact[one.contact], event.x_after).gap;
    for (auto& setting : setting_) setting.contact[one.contact].gap.value = gap;
  }
  const double rounding = system_.setting().rounding;
  allow_rounding(base_, rounding);
  for (auto& setting : setting_) allow_rounding(setting, rounding);
}

/// Rates of bodies behind one of several guards alone.
template <int D>
std::vector<double> BodiesVariation<D>::rates_behind(const BodiesPassage<D>& event, Index guard) const {
  auto mode = event.before;
  std::vector<double> x(event.x_before.begin(), event.x_before.end());
  std::vector<model::BodiesChange> ignored;
  system_.problem(mode);
  system_.transition(mode, {guard}, x, ignored);
  std::vector<double> rates(x.size());
  system_.problem(mode).derivative(x, rates);
  return rates;
}

template <int D>
SlopeMatrix BodiesVariation<D>::pass(const BodiesPassage<D>& event, const SlopeMatrix& slopes) {
  keep_totals(event, slopes);
  see_fading(event);
  begin_at_zero(event);
  SlopeMatrix result(std::ssize(event.x_after), columns());
  const Index of_bodies = system_.layout(event.x_after).spring(0);
  const bool several = event.guard.size() > 1;
  for (Index c = 0; c < columns(); ++c)
    for (Index row = 0; row < of_bodies; ++row) result(row, c) = slopes(row, c);
  for (std::size_t k = 0; k < event.guard.size(); ++k) {
    const auto alone = several ? rates_behind(event, event.guard[k]) : std::vector<double>();
    const ConstState behind = several ? ConstState(alone) : event.rate_after;
    for (Index c = 0; c < columns(); ++c)
      for (Index row = 0; row < of_bodies; ++row)
        if (const double jump = event.rate_before[row] - behind[row]; jump != 0)
          result(row, c) += jump * event.time[k][c];
  }
  for (const auto& one : event.after.closed) pass_slot(event, one, slopes, result);
  if (comes_to_rest(event.before, event.after)) stop_slip(event.after, event.x_after, result);
  return result;
}

template std::vector<Index> BodiesVariation<2>::telling(const std::vector<Index>&, const BodiesMode&,
                                                        const BodiesMode&) const;
template std::vector<Index> BodiesVariation<3>::telling(const std::vector<Index>&, const BodiesMode&,
                                                        const BodiesMode&) const;
template SlopeMatrix BodiesVariation<2>::pass(const BodiesPassage<2>&, const SlopeMatrix&);
template SlopeMatrix BodiesVariation<3>::pass(const BodiesPassage<3>&, const SlopeMatrix&);

}  // namespace mariotte::impact
