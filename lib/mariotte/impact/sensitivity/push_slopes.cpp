#include "mariotte/impact/sensitivity/push_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/impact/sensitivity/shallow_push.hpp"
#include "mariotte/model/chain/chain_topology.hpp"
#include "mariotte/model/network/network_topology.hpp"

namespace mariotte::impact {
namespace {

/// Of the accuracy of the run, which is better than what is asked for: what the last terms of a step may be.
constexpr double share = 10;
constexpr int most_pieces = 8;

}  // namespace

template <class Topology>
PushSlopes<Topology>::PushSlopes(const Scaled& model, const model::ContactLayout& layout,
                                 const std::vector<ContactSlope>& contacts, const SlopeMatrix& acceleration,
                                 const std::vector<double>& natural, double accuracy)
    : model_(model),
      layout_(layout),
      contact_(contacts),
      acceleration_(acceleration),
      natural_(natural),
      accuracy_(accuracy),
      reach_(layout.contacts()),
      number_(layout.size, -1),
      contact_at_(layout.size, -1) {
  const Topology topology{model, layout};
  for (Index v = 0; v < layout.velocities(); ++v) number_[layout.velocity[v]] = v;
  for (Index j = 0; j < layout.contacts(); ++j) {
    contact_at_[layout.gap[j]] = j;
    auto& own = reach_[j];
    topology.for_each_push(j, [&](Index place, double u) { own.push.push_back({number_[place], u}); });
    topology.for_each_direction(j, [&](Index place, double g) {
      own.direction.push_back({number_[place], g});
    });
    for (const auto& [v, u] : own.push)
      for (const auto& [moved, g] : own.direction)
        if (v == moved) own.mobility += u * g;
  }
}

/// Rate of the gap of contact j along a motion of the velocities.
template <class Topology>
double PushSlopes<Topology>::along(Index j, const SlopeMatrix& motion, Index column) const {
  double sum = 0;
  for (const auto& [v, g] : reach_[j].direction) sum += g * motion(v, column);
  return sum;
}

/// The same where velocities are at their places in a state.
template <class Topology>
double PushSlopes<Topology>::gap_rate(Index j, const SlopeMatrix& slopes, Index column) const {
  double sum = 0;
  for (const auto& [v, g] : reach_[j].direction) sum += g * slopes(layout_.velocity[v], column);
  return sum;
}

/// Contacts that push; false if some law or direction is not known here.
template <class Topology>
bool PushSlopes<Topology>::gather(const contact::ContactSet& mode) {
  pushing_.clear();
  for (Index j = 0; j < layout_.contacts(); ++j) {
    if (!contact_[j].direction.empty()) return false;
    if (!contact::carries_force(mode[j])) continue;
    if (!power_law(model_.law[j])) return false;
    pushing_.push_back(j);
  }
  return true;
}

/// Velocities and displacements without any push.
template <class Topology>
void PushSlopes<Topology>::fly(double duration, const SlopeMatrix& slopes) {
  for (Index c = 0; c < slopes.columns; ++c)
    for (Index v = 0; v < velocity_.rows; ++v) {
      const double speed = slopes(layout_.velocity[v], c), gain = duration * acceleration_(v, c);
      velocity_(v, c) = speed + gain;
      displacement_(v, c) = duration * (speed + 0.5 * gain);
    }
}

template <class Topology>
std::optional<AloneStep> PushSlopes<Topology>::alone_step(const flow::Step& step, Index j) const {
  const auto& law = *power_law(model_.law[j]);
  const Topology topology{model_, layout_};
  for (const auto& slope : contact_[j].law)
    if (slope.power.exponent != 0 || slope.power.damping != 0) return std::nullopt;
  const AloneStep alone{.exponent = law.exponent,
                        .kappa = law.stiffness * reach_[j].mobility,
                        .duration = step.end - step.start,
                        .depth = -step.before[layout_.gap[j]],
                        .rate = topology.approach(step.before, j),
                        .last_depth = -step.after[layout_.gap[j]],
                        .last_rate = topology.approach(step.after, j)};
  if (law.damping != 0 || topology.drive(j) != 0 || alone.depth < 0 || alone.last_depth < 0)
    return std::nullopt;
  return alone.energy() > 0 ? std::optional(alone) : std::nullopt;
}

template <class Topology>
bool PushSlopes<Topology>::follow_alone(const flow::Step& step, Index j, const SlopeMatrix& slopes) {
  const auto alone = alone_step(step, j);
  if (!alone) return false;
  const double h = alone->duration, rate = alone->rate, u = reach_[j].mobility;
  const double impulse = (rate - alone->last_rate) / u;
  const double travel = (alone->depth + rate * h - alone->last_depth) / u;
  fly(h, slopes);
  std::vector<double> by_mobility(slopes.columns), by_stiffness(slopes.columns);
  for (const auto& term : contact_[j].push)
    for (const auto& [v, g] : reach_[j].direction)
      if (v == number_[term.place]) by_mobility[term.column] += g * term.slope;
  for (const auto& slope : contact_[j].law) by_stiffness[slope.column] = slope.power.stiffness;
  const double stiffness = power_law(model_.law[j])->stiffness;
  for (Index c = 0; c < slopes.columns; ++c) {
    if (along(j, acceleration_, c) != 0) return false;
    const double start_rate = -gap_rate(j, slopes, c), start_depth = -slopes(layout_.gap[j], c);
    const double stretch = 0.5 * (by_stiffness[c] / stiffness + by_mobility[c] / u);
    const auto [end_depth, end_rate] = alone->slopes(start_depth, start_rate, stretch);
    give(j, c, (start_rate - end_rate - by_mobility[c] * impulse) / u,
         (start_depth + h * start_rate - end_depth - by_mobility[c] * travel) / u);
  }
  for (const auto& term : contact_[j].push) {
    velocity_(number_[term.place], term.column) += term.slope * impulse;
    displacement_(number_[term.place], term.column) += term.slope * travel;
  }
  return true;
}

/// An impulse, and its integral.
template <class Topology>
void PushSlopes<Topology>::give(Index j, Index column, double impulse, double travel) {
  impulse_(j, column) = impulse;
  for (const auto& [v, u] : reach_[j].push) {
    velocity_(v, column) += u * impulse;
    displacement_(v, column) += u * travel;
  }
}

/// Nothing but the series of these contacts, as far along their clock as it holds; 0 if that is nowhere.
template <class Topology>
double PushSlopes<Topology>::expand(const flow::PushSeries& series, const SlopeMatrix& slopes) {
  start_.reset(velocity_.rows, slopes.columns);
  for (Index c = 0; c < slopes.columns; ++c)
    for (Index v = 0; v < velocity_.rows; ++v) start_(v, c) = slopes(layout_.velocity[v], c);
  depth_.reset(slopes.columns, std::ssize(series.contact));
  expanded_.clear();
  for (std::size_t k = 0; k < series.contact.size(); ++k) {
    const Index j = contact_at_[series.contact[k].gap];
    for (Index c = 0; c < slopes.columns; ++c) {
      depth_(c, k) = -slopes(layout_.gap[j], c);
      if (series.power > 0 && along(j, acceleration_, c) != 0) return 0;
    }
    expanded_.push_back(
        {*power_law(model_.law[j]), reach_[j].push, reach_[j].direction, &contact_[j], depth_.column(k)});
  }
  impulse_given_.reset(std::ssize(expanded_), slopes.columns);
  return expansion_->expand(series, {expanded_, start_, acceleration_, number_},
                            {share * accuracy_, natural_}, {velocity_, displacement_, impulse_given_});
}

/// Slopes need shorter pieces than the motion where their last terms are too large.
template <class Topology>
bool PushSlopes<Topology>::carry(flow::PushSeries& series, SlopeMatrix& slopes, int pieces) {
  const double reached = expand(series, slopes);
  if (reached == 0) return false;
  for (std::size_t k = 0; k < expanded_.size(); ++k)
    for (Index c = 0; c < slopes.columns; ++c)
      impulse_(contact_at_[series.contact[k].gap], c) = impulse_given_(k, c);
  finish(slopes);
  if (reached == series.end) return true;
  if (pieces == 1) return false;
  drop(series, reached);
  return carry(series, slopes, pieces - 1);
}

template <class Topology>
bool PushSlopes<Topology>::follow_series(const flow::Step& step, SlopeMatrix& slopes) {
  if (!step.series(series_) || !series_.has_roots) return false;
  for (const auto& one : series_.contact)
    if (!PushExpansion::knows(*power_law(model_.law[contact_at_[one.gap]]), contact_[contact_at_[one.gap]]))
      return false;
  moved_ = slopes;
  if (!carry(series_, moved_, most_pieces) || !add_shallow(step, slopes, moved_)) return false;
  slopes = moved_;
  return true;
}

/// Contacts so shallow that the flow leaves out their force must have no slope that matters, or only to first
/// order.
template <class Topology>
bool PushSlopes<Topology>::add_shallow(const flow::Step& step, const SlopeMatrix& before,
                                       SlopeMatrix& after) {
  for (const Index j : pushing_) {
    const auto is_own = [&](const auto& one) { return contact_at_[one.gap] == j; };
    if (std::any_of(series_.contact.begin(), series_.contact.end(), is_own)) continue;
    const Index gap = layout_.gap[j];
    const double gain = largest_gain(step, j);
    const auto change = [&](Index c) {
      return gain * std::max(std::abs(before(gap, c)), std::abs(after(gap, c)));
    };
    if (is_small(change)) continue;
    if (step.before[gap] != 0 || !push_shallow(step, j, before, after)) return false;
  }
  return true;
}

/// What contact j does in the step to the rate of its gap, per slope of that.
template <class Topology>
double PushSlopes<Topology>::largest_gain(const flow::Step& step, Index j) const {
  const auto stiffness_at = [&](ConstState x) {
    const double rate = Topology{model_, layout_}.approach(x, j);
    return std::abs(
        contact::smooth_force(*power_law(model_.law[j]), -x[layout_.gap[j]], rate).by_indentation);
  };
  const double stiffness = std::max(stiffness_at(step.before), stiffness_at(step.after));
  return (step.end - step.start) * reach_[j].mobility * stiffness;
}

/// Beside velocities at the end.
template <class Topology>
template <class Change>
bool PushSlopes<Topology>::is_small(Change&& change) const {
  for (Index c = 0; c < velocity_.columns; ++c) {
    double largest = natural_[c];
    for (Index v = 0; v < velocity_.rows; ++v) largest = std::max(largest, std::abs(velocity_(v, c)));
    if (change(c) > share * accuracy_ * largest) return false;
  }
  return true;
}

/// False if slopes of its depth are not straight enough.
template <class Topology>
bool PushSlopes<Topology>::push_shallow(const flow::Step& step, Index j, const SlopeMatrix& before,
                                        SlopeMatrix& after) {
  const Index gap = layout_.gap[j];
  const auto push = shallow_push(step, *power_law(model_.law[j]), gap, [&](ConstState x) {
    return Topology{model_, layout_}.approach(x, j);
  });
  displacement_.clear();
  impulse_.clear();
  for (Index c = 0; c < before.columns; ++c) {
    const double depth = -before(gap, c), rate = -gap_rate(j, before, c);
    give(j, c, push.impulse_by_depth * depth + push.impulse_by_rate * rate,
         push.travel_by_depth * depth + push.travel_by_rate * rate);
  }
  finish(after);
  return is_small([&](Index c) {
    const double rate = gap_rate(j, before, c);
    const double bend = after(gap, c) - before(gap, c) - (step.end - step.start) * rate;
    return reach_[j].mobility *
           (push.spring * std::abs(bend) + push.damper * std::abs(gap_rate(j, after, c) - rate));
  });
}

template <class Topology>
void PushSlopes<Topology>::finish(SlopeMatrix& slopes) const {
  const auto add = [&](Index place, double weight, const SlopeMatrix& motion, Index row) {
    for (Index c = 0; c < slopes.columns; ++c) slopes(place, c) += weight * motion(row, c);
  };
  for (Index v = 0; v < velocity_.rows; ++v)
    for (Index c = 0; c < slopes.columns; ++c) slopes(layout_.velocity[v], c) = velocity_(v, c);
  for (std::size_t j = 0; j < reach_.size(); ++j) {
    for (const auto& [v, g] : reach_[j].direction) add(layout_.gap[j], g, displacement_, v);
    const Index impulse = layout_.impulse[j];
    if (impulse != model::ContactLayout::absent) add(impulse, 1, impulse_, static_cast<Index>(j));
  }
}

template <class Topology>
bool PushSlopes<Topology>::advance(const flow::Step& step, const contact::ContactSet& mode,
                                   SlopeMatrix& slopes) {
  if (!gather(mode)) return false;
  if (velocity_.columns != slopes.columns) {
    velocity_ = displacement_ = SlopeMatrix(layout_.velocities(), slopes.columns);
    impulse_ = SlopeMatrix(layout_.contacts(), slopes.columns);
  }
  impulse_.clear();
  if (pushing_.size() == 1 && follow_alone(step, pushing_[0], slopes)) {
    finish(slopes);
    return true;
  }
  if (!pushing_.empty()) return follow_series(step, slopes);
  fly(step.end - step.start, slopes);
  finish(slopes);
  return true;
}

template class PushSlopes<model::ChainTopology>;
template class PushSlopes<model::NetworkTopology>;

}  // namespace mariotte::impact
