// Where errors grow by slowing down: what adhesion has held parts with what is left of its energy, v² − v_c²
// of a body that meets at v. So an error of the energy counts v/v_out times as much in the velocity v_out,
// and near capture decides whether there is one.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/hybrid/ending.hpp"
#include "mariotte/impact/impulses.hpp"
#include "mariotte/model/contacts/bound.hpp"

namespace mariotte::impact {

/// How many times a speed is smaller than another, as a power of two: the same in all units.
inline double times_slower(double before, double after) {
  constexpr double most = 1 / epsilon;
  return before > after ? power_of_two_below(after * most > before ? before / after : most) : 1;
}

/// Told of contacts that adhere, in order of time.
class Slowing {
 public:
  void meet(Index contact, double speed) { met_[contact] = speed; }
  void part(Index contact, double speed) {
    if (const auto met = met_.find(contact); met != met_.end())
      most_ = std::max(most_, times_slower(met->second, std::max(speed, 0.0)));
  }
  /// How many times slower than they met the two of a contact parted, at most.
  double most() const { return most_; }

 private:
  std::map<Index, double> met_;
  double most_ = 1;
};

/// Of the changes of contacts with these laws, and of those that stay closed: they lack a speed to come off.
/// One that has been indented from the start has met at no speed.
template <class Changes>
double slowing(const Changes& changes, const std::vector<contact::Law>& laws,
               const std::vector<model::LackedSpeed>& held = {}) {
  Slowing slowing;
  if (std::none_of(laws.begin(), laws.end(), contact::adheres)) return 1;
  for (const auto& [time, change] : changes) {
    if (!contact::adheres(laws[static_cast<std::size_t>(change.contact)])) continue;
    if (starts_force(change)) slowing.meet(change.contact, change.approach);
    if (ends_force(change)) slowing.part(change.contact, -change.approach);
  }
  for (const auto& [contact, speed] : held) slowing.part(contact, speed);
  return slowing.most();
}

/// Of a run of a system, which may have ended bound.
template <class System, class Run>
double slowing(const System& system, const contact::ContactSet& mode, const Run& run,
               const std::vector<contact::Law>& laws) {
  if (run.ending != hybrid::Ending::bound) return slowing(run.changes, laws);
  return slowing(run.changes, laws, system.lacked_speeds(mode, run.state));
}

}  // namespace mariotte::impact
