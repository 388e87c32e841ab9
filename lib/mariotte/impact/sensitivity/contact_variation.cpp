#include "mariotte/impact/sensitivity/contact_variation.hpp"

#include <algorithm>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/core/bracket.hpp"
#include "mariotte/model/chain/chain_topology.hpp"
#include "mariotte/model/network/network_topology.hpp"

namespace mariotte::impact {

using contact::Law;
using contact::Memory;
using model::force_in;
using model::GuardKind;
using model::level;
using model::memory_of;

template <class Topology>
ContactVariation<Topology>::ContactVariation(const Scaled& model, const model::ContactLayout& layout,
                                             Index columns, double accuracy)
    : model_(model),
      layout_(layout),
      columns_(columns),
      natural_(columns),
      contact_(layout.contacts()),
      near_yield_(layout.contacts(), infinity),
      near_closing_(layout.contacts(), infinity),
      acceleration_(layout.velocities(), columns_),
      peak_(columns_, layout.contacts()),
      base_(layout.contacts()),
      push_slopes_(model, layout, contact_, acceleration_, natural_, accuracy) {
  for (Index j = 0; j < layout.contacts(); ++j) read(model, j, base_[j]);
}

namespace {

/// By how much numbers of a law may differ by rounding: a damping is the root of an equation.
constexpr double law_rounding = 64 * epsilon;

bool same(const Law& a, const Law& b) {
  if (const auto* power = power_law(a), *other = power_law(b); power && other)
    return power->stiffness == other->stiffness && power->damping == other->damping &&
           power->exponent == other->exponent;
  const auto one = parameters(a), other = parameters(b);
  for (std::size_t i = 0; i < one.size(); ++i)
    if (one[i].value != other[i].value) return false;
  return one.size() == other.size();
}

}  // namespace

template <class Topology>
void ContactVariation<Topology>::add(const ShiftedModel<Scaled>& shifted) {
  const Topology base{model_, layout_}, moved{shifted.model, layout_};
  natural_[shifted.column] = natural_slope(shifted.step);
  for (Index i = 0; i < layout_.velocities(); ++i)
    acceleration_(i, shifted.column) += shifted.share() * (moved.acceleration(i) - base.acceleration(i));
  for (Index j = 0; j < layout_.contacts(); ++j) {
    add_directions(j, shifted);
    add_law(j, shifted);
  }
  if (shifted.is_first()) first_law_ = shifted.model.law;
}

template <class Topology>
std::vector<Index> ContactVariation<Topology>::unneeded() const {
  std::vector<Index> list;
  for (const Index work : layout_.work)
    if (work != model::ContactLayout::absent) list.push_back(work);
  return list;
}

template <class Topology>
void ContactVariation<Topology>::read(const Scaled& model, Index j, Directions& directions) const {
  const Topology topology{model, layout_};
  const auto into = [](PlacedCoefficients& list) {
    list.clear();
    return [&list](Index place, double value) { list.add(place, value); };
  };
  topology.for_each_push(j, into(directions.push));
  topology.for_each_direction(j, into(directions.direction));
}

template <class Topology>
void ContactVariation<Topology>::add_directions(Index j, const ShiftedModel<Scaled>& shifted) {
  const auto add = [&](const PlacedCoefficients& base, const PlacedCoefficients& moved,
                       std::vector<ContactSlope::Term>& slopes) {
    if (!(moved == base)) add_difference(base, moved, shifted.column, shifted.share(), slopes);
    if (shifted.is_last()) drop_rounding(base, shifted.column, shifted.step, slopes);
  };
  read(shifted.model, j, moved_);
  add(base_[j].push, moved_.push, contact_[j].push);
  add(base_[j].direction, moved_.direction, contact_[j].direction);
}

/// A law that moves differs at some point from the first one; not from the base, which is not restated, and
/// differs by rounding. From there on, and for the points before, it is kept.
template <class Topology>
void ContactVariation<Topology>::add_law(Index j, const ShiftedModel<Scaled>& shifted) {
  const auto& law = shifted.model.law[j];
  auto& list = contact_[j].law;
  const bool has_moved = !list.empty() && list.back().column == shifted.column;
  if (shifted.is_first() || (!has_moved && same(law, first_law_[j]))) return;
  if (!has_moved)
    list.push_back({.column = shifted.column,
                    .step = shifted.step,
                    .points = shifted.points,
                    .shifted = std::vector<Law>(shifted.k, first_law_[j])});
  list.back().shifted.push_back(law);
  if (shifted.is_last()) set_power(j, list.back());
}

template <class Topology>
void ContactVariation<Topology>::set_power(Index j, LawSlope& law) const {
  const auto* base = power_law(model_.law[j]);
  if (!base) return;
  const auto slope_of = [&](double contact::PowerLaw::*number) {
    const double slope = by_law(law, [&](const Law& moved) { return power_law(moved)->*number; });
    return std::abs(slope * law.step) > law_rounding * std::abs(base->*number) ? slope : 0;
  };
  law.power = {.stiffness = slope_of(&contact::PowerLaw::stiffness),
               .damping = slope_of(&contact::PowerLaw::damping),
               .exponent = slope_of(&contact::PowerLaw::exponent)};
}

template <class Topology>
double ContactVariation<Topology>::rate_slope(Index j, Index column, ConstState x) const {
  double sum = 0;
  for (const auto& term : contact_[j].direction)
    if (term.column == column) sum -= term.slope * x[term.place];
  return sum;
}

template <class Topology>
void ContactVariation<Topology>::source(ConstState x, const contact::ContactSet& mode, SlopeMatrix& b) const {
  b.clear();
  for (Index c = 0; c < columns_; ++c)
    for (Index i = 0; i < layout_.velocities(); ++i) b(layout_.velocity[i], c) = acceleration_(i, c);
  for (Index j = 0; j < layout_.contacts(); ++j) {
    for (const auto& term : contact_[j].direction)
      b(layout_.gap[j], term.column) += term.slope * x[term.place];
    if (contact::carries_force(mode[j])) add_force(j, x, mode, b);
  }
}

/// What the force of contact j does as its law, its memory and its directions change.
template <class Topology>
void ContactVariation<Topology>::add_force(Index j, ConstState x, const contact::ContactSet& mode,
                                           SlopeMatrix& b) const {
  const Topology topology{model_, layout_};
  const auto& own = contact_[j];
  const auto& base = model_.law[j];
  const double indentation = -x[layout_.gap[j]], rate = topology.approach(x, j);
  const auto past = memory_of(mode, j);
  const auto f = force_in(mode[j], base, indentation, rate, past);
  const auto add = [&](Index c, double force_slope) {
    topology.for_each_push(j, [&](Index place, double change) { b(place, c) += change * force_slope; });
    if (layout_.impulse[j] != model::ContactLayout::absent) b(layout_.impulse[j], c) += force_slope;
  };
  for (const auto& term : own.push) b(term.place, term.column) += term.slope * f.value;
  for (const auto& law : own.law)
    add(law.column, law_force_slope(mode[j], base, law, indentation, rate, past));
  for (Index c = 0; c < columns_ && !own.direction.empty(); ++c)
    if (const double turned = rate_slope(j, c, x); turned != 0) add(c, f.by_rate * turned);
  if (!(past.peak > 0)) return;
  const double by_peak = memory_force_slope(mode[j], base, indentation, rate, past);
  for (Index c = 0; c < columns_; ++c)
    if (peak_(c, j) != 0) add(c, by_peak * peak_(c, j));
}

template <class Topology>
void ContactVariation<Topology>::guard_slopes(Index i, ConstState x, const contact::ContactSet& mode,
                                              std::span<double> slopes) const {
  const Index j = layout_.guard_contact[i];
  const auto& own = contact_[j];
  const auto& base = model_.law[j];
  const auto past = memory_of(mode, j);
  const auto kind = layout_.kind(i);
  const double indentation = -x[layout_.gap[j]], rate = Topology{model_, layout_}.approach(x, j);
  const auto guard = [&](const Law& law, const Memory& memory) -> double {
    switch (kind) {
      case GuardKind::gap:
        return level(mode[j], law, memory, model_.noise_depth[j]);
      case GuardKind::load:
        return contact::load(law, indentation, rate).value;
      case GuardKind::yield:
        return -contact::branched(law)->yield_indentation(memory);
      case GuardKind::turn:
      case GuardKind::kink:  // what is driven is refused
        return 0;
    }
    return 0;
  };
  std::fill(slopes.begin(), slopes.end(), 0.0);
  for (const auto& law : own.law)
    slopes[law.column] += by_law(law, [&](const Law& moved) { return guard(moved, past); });
  if (past.peak > 0) {
    const double by_peak = by_memory(past, [&](const Memory& moved) { return guard(base, moved); });
    for (Index c = 0; c < columns_; ++c) slopes[c] += by_peak * peak_(c, j);
  }
  if (kind == GuardKind::gap || kind == GuardKind::yield) return;
  const double by_rate = kind == GuardKind::turn ? 1 : contact::load(base, indentation, rate).by_rate;
  for (Index c = 0; c < columns_; ++c) slopes[c] += by_rate * rate_slope(j, c, x);
}

template <class Topology>
double ContactVariation<Topology>::crossing_speed(Index i, double rate, const contact::ContactSet&) const {
  const Index j = layout_.guard_contact[i];
  const double speed = model_.speed, time = model_.time[j];
  switch (layout_.kind(i)) {
    case GuardKind::gap:
    case GuardKind::yield:
      return std::abs(rate) / speed;
    case GuardKind::turn:
      return std::abs(rate) * time / speed;
    case GuardKind::load: {
      const auto load = contact::load(model_.law[j], model_.length[j], 0);
      return std::abs(rate) * time / (load.by_indentation * model_.length[j] + load.by_rate * speed);
    }
    case GuardKind::kink:
      break;
  }
  return 1;
}

/// Indentation where contact j turns within a step, if it does.
template <class Topology>
std::optional<double> ContactVariation<Topology>::turning_point(const flow::Step& step, Index j) const {
  const Topology topology{model_, layout_};
  const double before = topology.approach(step.before, j), after = topology.approach(step.after, j);
  if (!(before > 0 && after <= 0)) return std::nullopt;
  std::vector<double> x(step.before.size());
  const auto approach = [&](double time) {
    step.at(time, x);
    return topology.approach(x, j);
  };
  approach(locate_sign_change(approach, step.start, before, step.end, after, 1e-12 * model_.time[j]));
  return -x[layout_.gap[j]];
}

/// What contact j would have to go on, where it turns within a step.
template <class Topology>
double ContactVariation<Topology>::left_to_yield(const flow::Step& step, Index j,
                                                 const contact::ContactSet& mode) const {
  const auto* branches = branched(model_.law[j]);
  if (!branches || mode[j] != contact::ContactMode::closed) return infinity;
  const auto past = memory_of(mode, j);
  const double yields = branches->yield_indentation(past);
  if (past.branch == contact::Branch::plastic || !(yields < infinity)) return infinity;
  const auto depth = turning_point(step, j);
  return depth && *depth > 0 ? yields - *depth : infinity;
}

template <class Topology>
void ContactVariation<Topology>::see(const flow::Step& step, const contact::ContactSet& mode) const {
  for (Index j = 0; j < layout_.contacts(); ++j) {
    near_yield_[j] = std::min(near_yield_[j], left_to_yield(step, j, mode) / model_.length[j]);
    if (mode[j] != contact::ContactMode::open) continue;
    if (const auto depth = turning_point(step, j))
      near_closing_[j] = std::min(near_closing_[j], -*depth / model_.length[j]);
  }
}

template <class Topology>
void ContactVariation<Topology>::jacobian(const flow::Problem& problem, ConstState x,
                                          const contact::ContactSet& mode, State values) const {
  constexpr double least = 1e-300;
  pressed_.assign(x.begin(), x.end());
  for (Index j = 0; j < layout_.contacts(); ++j) {
    double& gap = pressed_[layout_.gap[j]];
    if (mode[j] == contact::ContactMode::touching && contact::is_linear(model_.law[j]))
      gap = std::min(gap, -least);
  }
  problem.jacobian(pressed_, values);
}

template <class Topology>
std::vector<Index> ContactVariation<Topology>::unmet(const std::vector<Index>& fired,
                                                     const contact::ContactSet& before,
                                                     const contact::ContactSet& after) const {
  using contact::ContactMode;
  std::vector<Index> list;
  for (Index j = 0; j < layout_.contacts(); ++j) {
    if (before[j] != ContactMode::closed || after[j] != ContactMode::slack) continue;
    const bool has_fired = std::any_of(fired.begin(), fired.end(),
                                       [&](Index guard) { return layout_.guard_contact[guard] == j; });
    if (!has_fired) list.push_back(layout_.load_guard[j]);
  }
  return list;
}

template <class Topology>
std::vector<Index> ContactVariation<Topology>::guards_at_start(const contact::ContactSet& mode,
                                                               ConstState x) const {
  std::vector<Index> list;
  for (Index j = 0; j < layout_.contacts(); ++j)
    if (mode[j] == contact::ContactMode::closed && x[layout_.gap[j]] == 0) list.push_back(j);
  return list;
}

template <class Topology>
void ContactVariation<Topology>::remember(Index i, const contact::ContactSet& before,
                                          const contact::ContactSet& after, const SlopeMatrix& slopes,
                                          ConstState rate, std::span<const double> time) {
  const Index j = layout_.guard_contact[i], gap = layout_.gap[j];
  if (memory_of(before, j).peak == memory_of(after, j).peak) return;
  for (Index c = 0; c < columns_; ++c) peak_(c, j) = -(slopes(gap, c) + rate[gap] * time[c]);
}

template <class Topology>
double ContactVariation<Topology>::reach(const SlopeMatrix& slopes, Index column) const {
  double size = 100 * natural_[column];
  for (const Index place : layout_.velocity)
    size = std::max(size, std::abs(slopes(place, column)) / model_.speed);
  return size;
}

template <class Topology>
double ContactVariation<Topology>::gap_reach(Index i, const SlopeMatrix& slopes) const {
  const Index j = layout_.guard_contact[i];
  double most = 0;
  for (Index c = 0; c < columns_; ++c)
    most = std::max(most, std::abs(slopes(layout_.gap[j], c)) / model_.length[j] / reach(slopes, c));
  return most;
}

template <class Topology>
bool ContactVariation<Topology>::ends_steeply(Index i, const contact::ContactSet& mode) const {
  const Index j = layout_.guard_contact[i];
  const auto* branches = branched(model_.law[j]);
  if (!branches || layout_.kind(i) != GuardKind::gap) return false;
  const auto power = branches->power(memory_of(mode, j));
  return power && power->damping > 0 && damping_exponent(power->grows, power->exponent) < 0.5;
}

template <class Topology>
void ContactVariation<Topology>::meet(Index i, const contact::ContactSet& mode, State x) const {
  if (has_root(i, mode) && mode[i] != contact::ContactMode::hovering)
    x[layout_.gap[i]] = -level(mode[i], model_.law[i], memory_of(mode, i), 0);
}

template <class Topology>
void ContactVariation<Topology>::settle(Index i, const contact::ContactSet& before, State x) const {
  meet(i, before, x);
  if (layout_.kind(i) != GuardKind::gap || before[i] != contact::ContactMode::closed) return;
  if (!contact::adheres(model_.law[i])) return;
  const double deepest = std::max(model_.length[i], memory_of(before, i).peak);
  x[layout_.gap[i]] += 8 * epsilon * deepest;  // beyond the end by the last digits, where the law is cut off
}

template class ContactVariation<model::ChainTopology>;
template class ContactVariation<model::NetworkTopology>;

}  // namespace mariotte::impact
