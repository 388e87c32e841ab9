// What changes at the contacts that a steady wave passes without being followed.
#pragma once
#include "mariotte/core/instant.hpp"
#include "mariotte/hybrid/trajectory.hpp"
#include "mariotte/model/contacts/contact_automaton.hpp"
#include "mariotte/model/islands/repetition.hpp"

namespace mariotte::model {

/// Add to a run, which has come to `now`, the changes of the repetition: to each contact happens what
/// happened to the one `shift` before. Those that touched at rest have their first change behind them.
void repeat_changes(const Repetition& of, Instant now, hybrid::Trajectory<ContactChange>& run);

}  // namespace mariotte::model
