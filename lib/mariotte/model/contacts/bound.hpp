// Contacts that hold together for ever, and the frequencies at which they ring on.
//
// With A = G M⁻¹ Gᵀ of the closed contacts, their gap rates need the kinetic energy ½ ġᵀ A⁻¹ ġ at least, and
// what moves beyond that changes none of their gaps. So where no outside force acts, this energy and what the
// contacts store is kept, or lost to dampers. A contact opens only if that is more than it stores where it
// opens while all others of its cluster store as little as they can.
#pragma once
#include <vector>

#include "mariotte/model/contacts/contact_modes.hpp"

namespace mariotte::model {

/// A closed contact.
struct HeldContact {
  Index contact;
  const contact::BranchedLaw* law;
  contact::Memory past;
  double indentation, rate;
  double pull = 0;  ///< of outside forces that press its bodies together, alone [force]
};
/// An open one.
struct LooseContact {
  double clearance, approach;
  std::vector<double> coupling;  ///< to each closed contact
};
/// All contacts of a model at one instant; `coupling` is A, row by row.
struct HeldTogether {
  std::vector<HeldContact> held;
  std::vector<double> coupling;
  std::vector<LooseContact> loose;
  double noise_speed = 0;
};

/// True if no closed contact can open any more, and no open one can close. Sufficient, and for a lone contact
/// necessary as well.
bool is_bound(const HeldTogether& contacts);
/// Angular frequencies of small oscillations of the closed contacts about their rest, in ascending order.
std::vector<double> ringing(const HeldTogether& contacts);

/// How much faster the two of a closed contact would have to be to come off by themselves.
struct LackedSpeed {
  Index contact;
  double speed;
};
/// Of the contacts that lack any, if no other gives them energy.
std::vector<LackedSpeed> lacked_speeds(const HeldTogether& contacts);

/// Energy that adhesion can give the bodies of a fresh contact; 0 if it does not adhere.
double well_energy(const contact::Law& law);

/// The contacts of a state; `held` stays empty if one of the closed contacts does not adhere, or yields.
template <class Topology>
HeldTogether held_together(const ContactState<Topology>& state, const contact::ContactSet& mode) {
  const auto& topology = state.topology;
  const auto& model = state.model();
  HeldTogether all;
  all.noise_speed = model.noise_speed;
  for (Index j = 0; j < state.contacts(); ++j) {
    if (!contact::carries_force(mode[j])) continue;
    const auto* law = contact::branched(model.law[j]);
    const auto past = memory_of(mode, j);
    if (!law || !law->adheres() || past.branch == contact::Branch::plastic) return {};
    all.held.push_back(
        {j, law, past, -state.gap(j), state.approach(j), model.reduced_mass[j] * topology.drive(j)});
  }
  const auto couplings = [&](Index j, std::vector<double>& row) {
    for (const auto& one : all.held) {
      const Index i = one.contact;
      bool near = false;
      topology.for_each_near(j, [&](Index k) { near = near || k == i; });
      row.push_back(i == j ? 1 / model.reduced_mass[j] : near ? topology.coupling(j, i) : 0);
    }
  };
  for (const auto& one : all.held) couplings(one.contact, all.coupling);
  for (Index j = 0; j < state.contacts(); ++j) {
    if (contact::carries_force(mode[j])) continue;
    all.loose.push_back({.clearance = state.clearance(j), .approach = state.approach(j), .coupling = {}});
    couplings(j, all.loose.back().coupling);
  }
  return all;
}

}  // namespace mariotte::model
