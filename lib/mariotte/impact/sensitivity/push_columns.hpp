// What the slopes by several parameters start from, and what contacts do to each other, for one instruction
// set.
#pragma once
#include "mariotte/impact/sensitivity/push_forces.hpp"
#include "mariotte/impact/sensitivity/push_lanes.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

/// What contact `by` does to a velocity or to a depth, per impulse, and the slopes of that.
template <int N>
struct Effect {
  Index by;
  double share;
  Lanes<N> slope;
  bool has_slope;

  MARIOTTE_SERIES_INLINE void add_to(Lanes<N>& sum, const Lanes<N>& slope_of_impulse, double impulse) const {
    sum += share * slope_of_impulse;
    if (has_slope) sum += impulse * slope;
  }
};

template <int N>
using Effects = std::vector<Effect<N>>;

template <int N>
Effect<N>& effect_of(Effects<N>& list, Index by) {
  for (auto& one : list)
    if (one.by == by) return one;
  return list.emplace_back(Effect<N>{by, 0, Lanes<N>(0.0), false});
}

/// Slopes of depth and rate at the start; of what drives the rate, and of the law.
template <int N>
struct ContactColumns {
  const ContactSlope* source = nullptr;
  Lanes<N> depth, rate;
  Lanes<N> drive = Lanes<N>(0.0), stiffness = Lanes<N>(0.0), damping = Lanes<N>(0.0),
           exponent = Lanes<N>(0.0);
  bool has_drive = false, has_exponent = false;
};

/// As many parameters as N registers hold, from `first` on.
template <int N>
class Columns {
 public:
  using Pack = Lanes<N>;

  Index first = -1, count = 0;
  std::vector<ContactColumns<N>> contact;
  std::vector<Pack> velocity, drive;  ///< slopes of velocities and accelerations
  std::vector<Effects<N>> on_velocity, on_depth;

  void set(const Start& start, Index from) {
    if (from != first || !is_known(start)) {
      first = from;
      count = std::min<Index>(Pack::count, start.velocity.columns - first);
      set_model(start);
    }
    read(start.velocity, velocity);
    for (std::size_t j = 0; j < contact.size(); ++j) set_contact(start.contacts[j], contact[j]);
  }

 private:
  bool holds(Index column) const { return column >= first && column < first + count; }

  /// The contacts are those of the step before.
  bool is_known(const Start& start) const {
    return std::equal(contact.begin(), contact.end(), start.contacts.begin(), start.contacts.end(),
                      [](const ContactColumns<N>& own, const Contact& c) { return own.source == c.slope; });
  }

  void read(const SlopeMatrix& slopes, std::vector<Pack>& into) const {
    for (Index c = 0; c < count; ++c) {
      const auto column = slopes.column(first + c);
      for (std::size_t v = 0; v < into.size(); ++v) into[v][c] = column[v];
    }
  }

  /// What does not change from step to step.
  void set_model(const Start& start) {
    velocity.assign(static_cast<std::size_t>(start.velocity.rows), Pack(0.0));
    drive = velocity;
    read(start.acceleration, drive);
    on_velocity.assign(velocity.size(), {});
    on_depth.assign(start.contacts.size(), {});
    contact.assign(start.contacts.size(), {});
    for (std::size_t k = 0; k < contact.size(); ++k) add_pushes(start, static_cast<Index>(k));
    for (std::size_t j = 0; j < contact.size(); ++j) {
      contact[j].source = start.contacts[j].slope;
      set_law(start.contacts[j], contact[j]);
      add_effects(start.contacts[j], contact[j], on_depth[j]);
    }
  }

  void add_pushes(const Start& start, Index k) {
    const auto& own = start.contacts[k];
    for (const auto& [v, u] : own.push) effect_of(on_velocity[v], k).share += u;
    for (const auto& term : own.slope->push) {
      if (!holds(term.column)) continue;
      auto& one = effect_of(on_velocity[start.number[term.place]], k);
      one.slope[term.column - first] += term.slope;
      one.has_slope = true;
    }
  }

  void set_law(const Contact& given, ContactColumns<N>& own) const {
    for (const auto& law : given.slope->law) {
      if (!holds(law.column)) continue;
      own.stiffness[law.column - first] = law.power.stiffness;
      own.damping[law.column - first] = law.power.damping;
      own.exponent[law.column - first] = law.power.exponent;
      own.has_exponent |= law.power.exponent != 0;
    }
  }

  void add_effects(const Contact& given, ContactColumns<N>& own, Effects<N>& effects) const {
    for (const auto& [v, g] : given.direction) {
      own.drive += -g * drive[v];
      for (const auto& push : on_velocity[v]) {
        auto& one = effect_of(effects, push.by);
        one.share -= g * push.share;
        one.slope += -g * push.slope;
        one.has_slope |= push.has_slope;
      }
    }
    for (Index c = 0; c < count; ++c) own.has_drive |= own.drive[c] != 0;
  }

  void set_contact(const Contact& given, ContactColumns<N>& own) const {
    own.depth = own.rate = Pack(0.0);
    for (Index c = 0; c < count; ++c) own.depth[c] = given.depth[first + c];
    for (const auto& [v, g] : given.direction) own.rate += -g * velocity[v];
  }
};

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
