// The discrete state of one contact, and of all of them.
//
//   open     → closed    the gap falls to where the law begins: 0, or the bottom of a dent
//   open     → hovering  it does so slowly that the approach may be rounding: no force, no event
//   hovering → closed    the gap falls by θ more, the depth that such an approach cannot reach
//   closed   → hovering  shallower than θ/2 and moving as slowly: it has let go
//   open     → touching  touched at rest (gap = 0, no approach), now pressed by a neighbour
//   touching → closed    indented beyond the noise around 0: guards are watched; no event
//   touching → open      drawn apart before that
//   closed   → open      undamped: the gap rises to where the law ends: 0, a dent, or where adhesion gives
//   way closed   → slack     damped: the load k δ + c δ̇ falls through 0 while δ > 0 slack    → closed    the
//   load rises through 0: a neighbour pushes again slack    → open      the gap rises through 0
//
// A closed contact whose law yields or adheres changes its branch, too [contact/memory.hpp]:
//
//   elastic, unloading → plastic    the indentation rises to where the contact yields
//   plastic            → unloading  the rate of indentation falls through 0
//   any branch, if it adheres       the rate falls or rises through 0: the contact recedes or loads
#pragma once
#include <vector>

#include "mariotte/contact/memory.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::contact {

/// How a contact stands; the table at the top says what leads from one to the next.
enum class ContactMode : unsigned char { open, hovering, touching, closed, slack };

/// True of a contact that follows its law.
inline bool carries_force(ContactMode mode) {
  return mode == ContactMode::touching || mode == ContactMode::closed;
}

/// One mode per contact, and where a law remembers one memory per contact.
struct ContactSet : std::vector<ContactMode> {
  using std::vector<ContactMode>::vector;
  std::vector<Memory> memory;  ///< empty if no law remembers
  std::vector<Index> piece;    ///< of each drive: the piece of its signal that holds
};

}  // namespace mariotte::contact
