// How much slower than it met a tip leaves the plane that adhesion has held there.
#pragma once
#include "mariotte/hybrid/trajectory.hpp"
#include "mariotte/impact/slowing.hpp"
#include "mariotte/model/microbody/microbody_system.hpp"

namespace mariotte::impact {

/// Of a body that is captured, how fast it struck against the speed that it lacks to come off.
inline double slowing_in_capture(const model::MicrobodySystem& system, ConstState start, ConstState end) {
  const double lacks = -system.mechanics().stored(end), had = system.mechanics().kinetic(start);
  return lacks > 0 ? times_slower(std::sqrt(had), std::sqrt(lacks)) : 1;
}

inline double slowing(const model::MicrobodySystem& system, ConstState start,
                      const hybrid::Trajectory<model::MicrobodyChange>& run) {
  Slowing slowing;
  for (const auto& [time, change] : run.changes) {
    if (system.body().law[static_cast<std::size_t>(change.tip)].adhesion == 0) continue;
    if (change.event == model::TipEvent::close) slowing.meet(change.tip, change.speed);
    if (change.event == model::TipEvent::open) slowing.part(change.tip, change.speed);
  }
  return run.ending == hybrid::Ending::captured
             ? std::max(slowing.most(), slowing_in_capture(system, start, run.state))
             : slowing.most();
}

}  // namespace mariotte::impact
