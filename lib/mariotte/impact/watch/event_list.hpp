// What a run's changes of contact modes mean: events, periods, what was not needed. Same for every model.
#pragma once
#include <numbers>
#include <vector>

#include "mariotte/hybrid/trajectory.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/model/contacts/contact_automaton.hpp"

namespace mariotte::impact {

/// What a run over contacts leaves.
using ContactRun = hybrid::Trajectory<model::ContactChange>;
/// Changes of contacts with their times.
using ContactChanges = std::vector<hybrid::Timed<model::ContactChange>>;

/// Changes of one instant become one event; those that leave every force as it is become none. `unit` is that
/// of time.
std::vector<Event> event_list(const ContactChanges& changes, double unit);

/// Appends the periods of each contact, and how fast its bodies met and parted.
void add_periods(std::vector<ContactHistory>& contacts, const ContactChanges& changes, const Scale& scale);

/// Without contacts that touched at rest and were let go before they left the noise: these never closed,
/// unless they are among those that were `felt`. A strong damper gives an impulse within the noise of
/// indentations.
ContactChanges beyond_noise(const ContactChanges& changes, const std::vector<bool>& felt);

/// Contacts whose dampers may pull and that were closed until they had faded, ascending. Those of other laws
/// end as what a wave leaves behind does, if they fade.
std::vector<Index> faded_contacts(const ContactChanges& changes, const std::vector<contact::Law>& laws);

/// What the flows of a run made unnecessary.
std::vector<Skipped> skipped_by_flows(const ContactRun& run);

/// Frequencies of what rings on [Hz], if the run ended so.
template <class System>
std::vector<double> bound_frequencies(const System& system, const contact::ContactSet& mode,
                                      const ContactRun& run, const Scale& scale) {
  if (run.ending != hybrid::Ending::bound) return {};
  auto frequencies = system.ringing(mode, run.state);
  for (double& one : frequencies) one /= 2 * std::numbers::pi * scale.time;
  return frequencies;
}

/// A loss is a difference of two integrals; below the accuracy asked for its sign means nothing.
inline double loss_above(double noise, double loss) {
  return loss < 0 && loss > -noise ? 0 : loss;
}

}  // namespace mariotte::impact
