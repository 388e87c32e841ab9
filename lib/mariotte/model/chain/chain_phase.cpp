#include "mariotte/model/chain/chain_phase.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/contacts/scaled_law.hpp"

namespace mariotte::model {

using contact::ContactMode;
using flow::Crossing;

namespace {

/// Places of one contact's derivatives: the force pushes on both balls, the gap follows their velocities.
std::vector<flow::Entry> contact_pattern(const ChainLayout& at, Index j) {
  const Index left = at.velocity[j], right = at.velocity[j + 1], gap = at.gap[j];
  std::vector<flow::Entry> entries = {{gap, left}, {gap, right}};
  for (const Index row : {left, right, at.work[j], at.impulse[j]}) {
    if (row == ChainLayout::absent) continue;
    for (const Index column : {gap, left, right}) entries.push_back({row, column});
  }
  return entries;
}

void make_serial(const DimensionlessChain& chain, const ChainLayout& at, const ChainGuards& guards,
                 flow::SerialPhase& phase) {
  phase.body.clear();
  phase.contact.clear();
  phase.speed = chain.speed;
  phase.faint = chain.faint * chain.slow;
  for (Index i = 0; i < at.balls(); ++i)
    phase.body.push_back({at.velocity[i], chain.inverse_mass[i], -chain.gravity[i]});
  for (Index j = 0; j < at.contacts(); ++j) {
    const auto law = seen_by_flows(chain.law[j]);
    phase.contact.push_back({.gap = at.gap[j],
                             .work = at.work[j],
                             .impulse = at.impulse[j],
                             .guard = j,
                             .load_guard = guards.load[j],
                             .stiffness = law.stiffness,
                             .damping = law.damping,
                             .exponent = law.exponent,
                             .length = chain.length[j],
                             .shallow = chain.faint_depth * chain.shallow[j]});
  }
}

}  // namespace

void make_guards(const ChainLayout& layout, ChainGuards& guards) {
  guards.contact.clear();
  guards.load.clear();
  for (Index j = 0; j < layout.contacts(); ++j) guards.contact.push_back(j);
  for (Index j = 0; j < layout.contacts(); ++j) {
    const bool damped = layout.work[j] != ChainLayout::absent;
    guards.load.push_back(damped ? static_cast<Index>(guards.contact.size()) : ChainLayout::absent);
    if (damped) guards.contact.push_back(j);
  }
}

bool has_faded(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x, Index j) {
  const double approach = x[layout.velocity[j]] - x[layout.velocity[j + 1]];
  return -x[layout.gap[j]] < chain.faint_depth * chain.shallow[j] &&
         std::abs(approach) <= chain.faint * chain.slow;
}

bool has_loaded(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x, Index j) {
  const double indentation = -x[layout.gap[j]];
  if (!(indentation > 2 * chain.faint_depth * chain.shallow[j])) return false;
  return load(chain.law[j], indentation, x[layout.velocity[j]] - x[layout.velocity[j + 1]]).value > 0;
}

void ChainPhase::reset() {
  make_guards(layout_, guards_);
  model::magnitudes(chain_, layout_, magnitudes_);
  crossings_.assign(guards_.contact.size(), Crossing::none);
  make_serial(chain_, layout_, guards_, serial_);
}

void ChainPhase::set_edges(SliceEdges edges) {
  edges_ = edges;
  serial_.goes_on = edges.left || edges.right;
}

std::vector<flow::Entry> ChainPhase::pattern() const {
  std::vector<flow::Entry> pattern;
  for (Index j = 0; j < layout_.contacts(); ++j) {
    const auto entries = contact_pattern(layout_, j);
    pattern.insert(pattern.end(), entries.begin(), entries.end());
  }
  return pattern;
}

void ChainPhase::bind(contact::ContactSet& mode) {
  mode_ = &mode;
  active_ = 0;
  any_law_ = false;
  time_scale_ = infinity;
  double any = infinity;
  for (Index j = 0; j < layout_.contacts(); ++j) {
    watch(j);
    any_law_ |= role(mode[j]) != flow::Role::open && !power_law(chain_.law[j]);
    any = std::min(any, chain_.time[j]);
    if (!contact::carries_force(mode[j])) continue;
    ++active_;
    time_scale_ = std::min(time_scale_, chain_.time[j]);
  }
  if (active_ == 0) time_scale_ = any;
}

void ChainPhase::watch(Index j) {
  const ContactMode mode = (*mode_)[j];
  serial_.contact[j].role = role(mode);
  serial_.contact[j].level = level(j);
  const Index load_guard = guards_.load[j];
  const auto [gap, load] = watched(mode, chain_.law[j]);
  crossings_[j] = gap;
  if (load_guard != ChainLayout::absent) crossings_[load_guard] = load;
}

contact::Force ChainPhase::force(ConstState x, Index j) const {
  return force_in((*mode_)[j], chain_.law[j], -x[layout_.gap[j]], approach(x, j));
}

void ChainPhase::derivative(ConstState x, State dx) const {
  double push = 0;  // force of the contact on the left
  for (Index i = 0; i < layout_.balls(); ++i) {
    const bool last = i == layout_.contacts();
    const double force = last ? 0 : this->force(x, i).value;
    dx[layout_.velocity[i]] = (push - force) * chain_.inverse_mass[i] - chain_.gravity[i];
    push = force;
    if (last) break;
    dx[layout_.gap[i]] = -approach(x, i);
    if (layout_.work[i] != ChainLayout::absent) dx[layout_.work[i]] = force * approach(x, i);
    if (layout_.impulse[i] != ChainLayout::absent) dx[layout_.impulse[i]] = force;
  }
}

/// Gap, from where it is to be watched, or load.
double ChainPhase::guard(ConstState x, Index i) const {
  const Index j = guards_.contact[i];
  const double gap = x[layout_.gap[j]];
  return i == j ? gap : load(chain_.law[j], -gap, approach(x, j)).value;
}

void ChainPhase::guards(ConstState x, State values) const {
  // A masked guard stands on the side from which it cannot seem to have crossed when it is watched again.
  for (Index i = 0; i < guard_count(); ++i)
    values[i] = crossings_[i] != Crossing::none ? guard(x, i) + level(i) : i < layout_.contacts() ? -1 : 1;
}

/// A hovering contact closes where its gap is −level.
double ChainPhase::level(Index i) const {
  return i < layout_.contacts() && (*mode_)[i] == ContactMode::hovering ? chain_.shallow[i] : 0;
}

double ChainPhase::guard_rate(ConstState x, ConstState dx, Index i) const {
  const Index j = guards_.contact[i];
  if (i == j) return dx[layout_.gap[j]];
  const auto own = load(chain_.law[j], -x[layout_.gap[j]], approach(x, j));
  return own.by_rate * approach(dx, j) - own.by_indentation * dx[layout_.gap[j]];
}

void ChainPhase::guard_rates(ConstState x, ConstState dx, State rates) const {
  for (Index i = 0; i < guard_count(); ++i)
    rates[i] = crossings_[i] != Crossing::none ? guard_rate(x, dx, i) : 0;
}

void ChainPhase::jacobian(ConstState x, State values) const {
  std::size_t entry = 0;
  for (Index j = 0; j < layout_.contacts(); ++j) {
    const auto f = force(x, j);
    const auto row = [&](double factor) {  // of ∂(factor · f) by gap, left and right velocity
      values[entry++] = -factor * f.by_indentation;
      values[entry++] = factor * f.by_rate;
      values[entry++] = -factor * f.by_rate;
    };
    values[entry++] = -1;
    values[entry++] = 1;
    row(-chain_.inverse_mass[j]);
    row(chain_.inverse_mass[j + 1]);
    if (layout_.work[j] != ChainLayout::absent) {
      row(approach(x, j));
      values[entry - 2] += f.value;
      values[entry - 1] -= f.value;
    }
    if (layout_.impulse[j] != ChainLayout::absent) row(1);
  }
}

double ChainPhase::damping_ratio() const {
  double largest = 0;
  for (Index j = 0; j < layout_.contacts(); ++j) {
    if (layout_.work[j] == ChainLayout::absent || !contact::carries_force((*mode_)[j])) continue;
    largest = std::max(largest, model::damping_ratio(chain_, static_cast<std::size_t>(j)));
  }
  return largest;
}

void ChainPhase::second_derivative(ConstState, State ddx) const {
  std::fill(ddx.begin(), ddx.end(), 0.0);
  for (Index j = 0; j < layout_.contacts(); ++j)
    ddx[layout_.gap[j]] = chain_.gravity[j] - chain_.gravity[j + 1];
}

bool ChainPhase::is_at_edge(Index j) const {
  return (edges_.left && j < edges_.margin) || (edges_.right && j >= layout_.contacts() - edges_.margin);
}

flow::Accepted ChainPhase::accept(ConstState x) {
  auto accepted = flow::Accepted::unchanged;
  for (Index j = 0; j < layout_.contacts(); ++j) {
    if ((*mode_)[j] == ContactMode::closed && has_faded(chain_, layout_, x, j)) return flow::Accepted::ended;
    if ((*mode_)[j] != ContactMode::touching || !has_loaded(chain_, layout_, x, j)) continue;
    (*mode_)[j] = ContactMode::closed;
    if (is_at_edge(j)) return flow::Accepted::ended;
    watch(j);
    accepted = flow::Accepted::rewatched;
  }
  return accepted;
}

}  // namespace mariotte::model
