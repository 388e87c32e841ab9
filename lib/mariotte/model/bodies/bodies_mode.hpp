// The modes of contacts between bodies, and their table:
//
//   open ── gap falls through 0 ──▶ closed ── gap rises through 0 ──▶ open
//   touching ── pressed ──▶ closed;  touching ── parted ──▶ open       (gap 0 and at rest at the start)
//   closed: loading ⇄ unloading      δ̇ changes its sign
//   closed: active ⇄ slack           the load of a damped contact, or the force of one that can pull, changes
//                                    its sign: friction ends and begins
//   closed: on one branch of its law, or another [contact/branched_law.hpp]
//   closed: stick ⇄ slip             Coulomb's cap; slip that stops, which may be a reversal of a rigid law
#pragma once
#include <vector>

#include "mariotte/contact/memory.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/model/bodies/body_event.hpp"

namespace mariotte::model {

/// How friction acts in a closed contact.
enum class Friction { none, stick, slip };

/// One contact that is closed.
struct ClosedContact {
  Index contact = 0;
  Index slot = 0;  ///< its place in the state
  Friction friction = Friction::none;
  bool unloading = false;
  bool slack = false;
  double gap_noise = 0;           ///< what a few roundings of its gap may be
  contact::Memory past = {};      ///< where its law has branches
  double sign = 1;                ///< of slip along e_z × n, in the plane
  bool from_rest = false;         ///< rigid slip in space that has not left rest yet
  std::vector<double> start;      ///< where it goes to then
  std::vector<double> rest = {};  ///< slip that is left where it began, and counts as none
};

/// What a contact has exchanged since the start.
struct ContactTotals {
  double normal = 0;               ///< ∫ f_n dt [N s]
  std::vector<double> tangential;  ///< ∫ f_t dt: along e_z × n in the plane, a vector in space
  double friction = 0, rescale = 0, damper = 0;  ///< losses ≥ 0 [J]
};

/// Which contacts act, and how.
struct BodiesMode {
  std::vector<ClosedContact> closed;    ///< by contact
  std::vector<Index> touching;          ///< at rest at gap 0 since the start
  std::vector<Index> idle;              ///< slots that nobody uses
  std::vector<ContactTotals> totals;    ///< of periods that have ended, per contact
  std::vector<contact::Memory> memory;  ///< of contacts that are open; empty if no law remembers
  std::vector<Index> near;              ///< pairs that can meet before a body has gone half the skin
  std::vector<double> from;             ///< places of the bodies when `near` was made; empty if it is not
};

/// Changes of one contact.
struct BodiesChange {
  Index contact;
  BodyEvent event;
  double approach = 0;  ///< −ġ where it closes or opens
};

/// Guards of a closed contact.
enum class SlotGuard { open, friction, turn, load, yield };
inline constexpr Index guards_per_slot = 5;

/// What a contact that is open remembers.
inline contact::Memory memory_of(const BodiesMode& mode, Index contact) {
  return mode.memory.empty() ? contact::Memory{} : mode.memory[contact];
}

}  // namespace mariotte::model
