#include "mariotte/model/contacts/contact_automaton.hpp"

#include <algorithm>

namespace mariotte::model {

using contact::Branch;
using contact::ContactMode;
using flow::Crossing;

namespace {

void note(const contact::ContactSet& mode, Index j, Branch before, std::vector<ContactChange>& changes) {
  changes.push_back({j, mode[j], mode[j], before, mode.memory[j].branch});
}

}  // namespace

void change(contact::ContactSet& mode, Index j, ContactMode after, const contact::Law& law,
            std::vector<ContactChange>& changes) {
  if (mode[j] == after) return;
  const auto before = memory_of(mode, j).branch;
  if (const auto* branches = branched(law)) {
    auto& past = mode.memory[j];
    if (!carries_force(mode[j]) && carries_force(after)) begin(past, *branches);
    if (mode[j] == ContactMode::closed && !carries_force(after)) end(past, *branches);
  }
  changes.push_back({j, mode[j], after, before, memory_of(mode, j).branch});
  mode[j] = after;
}

void yield(contact::ContactSet& mode, Index j, std::vector<ContactChange>& changes) {
  const auto before = mode.memory[j].branch;
  yield(mode.memory[j]);
  note(mode, j, before, changes);
}

void turn(contact::ContactSet& mode, Index j, const contact::Law& law, double indentation,
          std::vector<ContactChange>& changes) {
  const auto before = mode.memory[j].branch;
  turn(mode.memory[j], *branched(law), indentation);
  note(mode, j, before, changes);
}

void start_indented(contact::Memory& past, const contact::Law& law, double indentation, double rate) {
  const auto* branches = branched(law);
  if (!branches) return;
  past = loaded_first(*branches, indentation);
  if (rate < 0) turn(past, *branches, indentation);
}

void reset(contact::ContactSet& mode, const std::vector<contact::Law>& laws) {
  mode.assign(laws.size(), ContactMode::open);
  const bool remembers =
      std::any_of(laws.begin(), laws.end(), [](const auto& law) { return contact::branched(law); });
  mode.memory.assign(remembers ? laws.size() : 0, {});
}

void copy_slice(const contact::ContactSet& from, Index first, Index last, contact::ContactSet& to) {
  to.assign(from.begin() + first, from.begin() + last);
  to.memory.clear();
  if (!from.memory.empty()) to.memory.assign(from.memory.begin() + first, from.memory.begin() + last);
}

void put_slice(const contact::ContactSet& slice, Index first, contact::ContactSet& to) {
  std::copy(slice.begin(), slice.end(), to.begin() + first);
  std::copy(slice.memory.begin(), slice.memory.end(), to.memory.begin() + first * !slice.memory.empty());
}

void open_touching(contact::ContactSet& mode, const std::vector<contact::Law>& laws,
                   std::vector<ContactChange>& changes) {
  for (Index j = 0; j < std::ssize(mode); ++j)
    if (mode[j] == ContactMode::touching) change(mode, j, ContactMode::open, laws[j], changes);
}

ContactMode mode_after(ContactMode mode, bool load_fired, double gap, double approach, double noise_speed) {
  switch (mode) {
    case ContactMode::open:
      return approach > noise_speed ? ContactMode::closed : ContactMode::hovering;
    case ContactMode::hovering:
      return ContactMode::closed;
    case ContactMode::slack:
      return load_fired ? ContactMode::closed : ContactMode::open;
    case ContactMode::closed:
      return load_fired && gap < 0 ? ContactMode::slack : ContactMode::open;
    case ContactMode::touching:
      return ContactMode::open;
  }
  return mode;
}

flow::Role role(ContactMode mode) {
  using flow::Role;
  switch (mode) {
    case ContactMode::open:
    case ContactMode::hovering:
      return Role::open;
    case ContactMode::touching:
      return Role::touching;
    case ContactMode::closed:
      return Role::closed;
    case ContactMode::slack:
      return Role::slack;
  }
  return Role::open;
}

namespace {

/// The law may still yield from this branch on.
bool yields(const contact::Law& law, const contact::Memory& past) {
  const auto* branches = branched(law);
  return branches && past.branch != Branch::plastic && branches->yield_indentation(past) < infinity;
}

Watched watched_closed(const contact::BranchedLaw& law, const contact::Memory& past) {
  Watched watched{Crossing::rising, Crossing::none};
  if (!law.watches_turns()) return watched;
  const bool plastic = past.branch == contact::Branch::plastic, turns = plastic || law.adheres();
  if (turns) watched.turn = past.recedes ? Crossing::rising : Crossing::falling;
  const bool can_yield = !plastic && !(turns && past.recedes);
  if (can_yield && law.yield_indentation(past) < infinity) watched.yield = Crossing::rising;
  return watched;
}

}  // namespace

Watched watched(ContactMode mode, const contact::Law& law, const contact::Memory& past) {
  switch (mode) {
    case ContactMode::open:
    case ContactMode::hovering:
      return {Crossing::falling, Crossing::none};
    case ContactMode::slack:
      return {Crossing::rising, Crossing::rising};
    case ContactMode::touching:
      return {Crossing::none, Crossing::none, yields(law, past) ? Crossing::rising : Crossing::none};
    case ContactMode::closed:
      if (const auto* branches = branched(law)) return watched_closed(*branches, past);
      if (!dissipates(law)) break;
      // The load of a power law falls before the gap opens, or with it; that of another law need not.
      return {power_law(law) ? Crossing::none : Crossing::rising, Crossing::falling};
  }
  return {Crossing::rising, Crossing::none};
}

contact::Force force_in(ContactMode mode, const contact::Law& law, double indentation, double rate,
                        const contact::Memory& past) {
  const auto* branches = branched(law);
  switch (mode) {
    case ContactMode::closed:
      return branches ? branches->force(past, indentation, rate)
                      : contact::smooth_force(law, indentation, rate);
    case ContactMode::touching:
      return branches && indentation > 0 ? branches->force(past, indentation, rate)
                                         : contact::force(law, std::max(0.0, indentation), rate);
    default:
      return {0, 0, 0};
  }
}

double level(ContactMode mode, const contact::Law& law, const contact::Memory& past, double noise_depth) {
  const double hovers = mode == ContactMode::hovering ? noise_depth : 0;
  const auto* branches = branched(law);
  if (!branches) return hovers;
  return mode == ContactMode::closed ? branches->opening_indentation(past)
                                     : branches->closing_indentation(past) + hovers;
}

}  // namespace mariotte::model
