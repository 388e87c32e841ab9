#include "mariotte/model/network/network_phase.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/model/contacts/scaled_law.hpp"
#include "mariotte/model/network/network_links.hpp"

namespace mariotte::model {

using contact::ContactMode;
using flow::Crossing;

NetworkPhase::NetworkPhase(const DimensionlessNetwork& network, const NetworkLayout& layout)
    : network_(network),
      layout_(layout),
      magnitudes_(model::magnitudes(network, layout)),
      crossings_(layout.guard_contact.size(), Crossing::none),
      row_(places_in_row(network)) {
  if (row_.empty())
    linked_ = make_linked(network, layout);
  else
    serial_ = make_serial(network, layout, row_);
}

void NetworkPhase::bind(contact::ContactSet& mode) {
  mode_ = &mode;
  active_ = 0;
  any_law_ = false;
  double shortest = infinity, any = infinity;
  for (Index j = 0; j < layout_.contacts; ++j) {
    watch(j);
    any_law_ |= role(mode[j]) != flow::Role::open && !power_law(network_.law[j]);
    any = std::min(any, network_.time[j]);
    if (!contact::carries_force(mode[j])) continue;
    ++active_;
    shortest = std::min(shortest, network_.time[j]);
  }
  time_scale_ = active_ == 0 ? any : shortest;
}

void NetworkPhase::watch(Index j) {
  const Index load_guard = layout_.load_guard[j];
  const auto [gap, load] = watched((*mode_)[j], network_.law[j]);
  crossings_[j] = gap;
  if (load_guard != NetworkLayout::absent) crossings_[load_guard] = load;
  auto& contact = row_.empty() ? linked_.contact[j] : serial_.contact[row_[j]];
  contact.role = role((*mode_)[j]);
  contact.level = level(j);
}

contact::Force NetworkPhase::force(ConstState x, Index j) const {
  return force_in((*mode_)[j], network_.law[j], -x[layout_.gap(j)], approach(x, j));
}

void NetworkPhase::derivative(ConstState x, State dx) const {
  std::fill(dx.begin(), dx.end(), 0.0);
  for (Index j = 0; j < layout_.contacts; ++j) {
    const double rate = approach(x, j);
    dx[layout_.gap(j)] = -rate;
    if (!contact::carries_force((*mode_)[j])) continue;
    const double f = force(x, j).value;
    dx[layout_.impulse(j)] = f;
    if (layout_.work[j] != NetworkLayout::absent) dx[layout_.work[j]] = f * rate;
    for (const auto& [freedom, change] : network_.push[j]) dx[freedom] += change * f;
  }
}

/// Gap, from where it is to be watched, or load.
double NetworkPhase::guard(ConstState x, Index i) const {
  const Index j = layout_.guard_contact[i];
  const double gap = x[layout_.gap(j)];
  return i == j ? gap : load(network_.law[j], -gap, approach(x, j)).value;
}

void NetworkPhase::guards(ConstState x, State values) const {
  // A masked guard stands on the side from which it cannot seem to have crossed when it is watched again.
  for (Index i = 0; i < guard_count(); ++i)
    values[i] = crossings_[i] != Crossing::none ? guard(x, i) + level(i) : i < layout_.contacts ? -1 : 1;
}

double NetworkPhase::level(Index i) const {
  return i < layout_.contacts && (*mode_)[i] == ContactMode::hovering ? network_.shallow[i] : 0;
}

double NetworkPhase::guard_rate(ConstState x, ConstState dx, Index i) const {
  const Index j = layout_.guard_contact[i];
  if (i == j) return dx[layout_.gap(j)];
  const auto own = load(network_.law[j], -x[layout_.gap(j)], approach(x, j));
  return own.by_rate * approach(dx, j) - own.by_indentation * dx[layout_.gap(j)];
}

void NetworkPhase::guard_rates(ConstState x, ConstState dx, State rates) const {
  for (Index i = 0; i < guard_count(); ++i)
    rates[i] = crossings_[i] != Crossing::none ? guard_rate(x, dx, i) : 0;
}

std::vector<flow::Entry> NetworkPhase::pattern() const {
  std::vector<flow::Entry> pattern;
  for (Index j = 0; j < layout_.contacts; ++j) {
    for (const auto& term : network_.direction[j]) pattern.push_back({layout_.gap(j), term.freedom});
    const auto row = [&](Index place) {
      pattern.push_back({place, layout_.gap(j)});
      for (const auto& term : network_.direction[j]) pattern.push_back({place, term.freedom});
    };
    for (const auto& term : network_.push[j]) row(term.freedom);
    row(layout_.impulse(j));
    if (layout_.work[j] != NetworkLayout::absent) row(layout_.work[j]);
  }
  return pattern;
}

void NetworkPhase::jacobian(ConstState x, State values) const {
  std::size_t entry = 0;
  for (Index j = 0; j < layout_.contacts; ++j) {
    const auto f = force(x, j);
    for (const auto& term : network_.direction[j]) values[entry++] = term.coefficient;
    // ∂(factor · f + extra · δ̇) by the gap and by the velocities, with δ̇ = −G v
    const auto row = [&](double factor, double extra) {
      values[entry++] = -factor * f.by_indentation;
      for (const auto& term : network_.direction[j])
        values[entry++] = -(factor * f.by_rate + extra) * term.coefficient;
    };
    for (const auto& term : network_.push[j]) row(term.coefficient, 0);
    row(1, 0);
    if (layout_.work[j] != NetworkLayout::absent) row(approach(x, j), f.value);
  }
}

double NetworkPhase::damping_ratio() const {
  double largest = 0;
  for (Index j = 0; j < layout_.contacts; ++j) {
    if (!contact::carries_force((*mode_)[j])) continue;
    largest = std::max(largest, model::damping_ratio(network_, static_cast<std::size_t>(j)));
  }
  return largest;
}

void NetworkPhase::second_derivative(ConstState, State ddx) const {
  std::fill(ddx.begin(), ddx.end(), 0.0);
}

bool NetworkPhase::has_faded(ConstState x, Index j) const {
  const double rate = approach(x, j);
  return (*mode_)[j] == ContactMode::closed && -x[layout_.gap(j)] < network_.shallow[j] && rate <= 0 &&
         rate >= -network_.slow;
}

bool NetworkPhase::has_parted(ConstState x, Index j) const {
  return (*mode_)[j] == ContactMode::touching && x[layout_.gap(j)] > 2 * network_.shallow[j];
}

/// A touching contact has left the noise.
bool NetworkPhase::has_loaded(ConstState x, Index j) const {
  if ((*mode_)[j] != ContactMode::touching || !(-x[layout_.gap(j)] > 2 * network_.shallow[j])) return false;
  return layout_.work[j] == NetworkLayout::absent || force(x, j).value > 0;
}

flow::Accepted NetworkPhase::accept(ConstState x) {
  auto accepted = flow::Accepted::unchanged;
  for (Index j = 0; j < layout_.contacts; ++j) {
    if (has_faded(x, j) || has_parted(x, j)) return flow::Accepted::ended;
    if (!has_loaded(x, j)) continue;
    (*mode_)[j] = ContactMode::closed;
    watch(j);
    accepted = flow::Accepted::rewatched;
  }
  return accepted;
}

}  // namespace mariotte::model
