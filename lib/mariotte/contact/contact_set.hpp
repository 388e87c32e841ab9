// The discrete state of one contact, and of all of them.
//
//   open     → closed    the gap falls through 0
//   open     → hovering  it does so slowly that the approach may be rounding: no force, no event
//   hovering → closed    the gap falls through −θ, the depth that such an approach cannot reach
//   closed   → hovering  shallower than θ and moving as slowly: it has let go
//   open     → touching  touched at rest (gap = 0, no approach), now pressed by a neighbour
//   touching → closed    indented beyond the noise around 0: guards are watched; no event
//   touching → open      drawn apart before that
//   closed   → open      undamped: the gap rises through 0
//   closed   → slack     damped: the load k δ + c δ̇ falls through 0 while δ > 0
//   slack    → closed    the load rises through 0: a neighbour pushes again
//   slack    → open      the gap rises through 0
#pragma once
#include <vector>

namespace mariotte::contact {

/// How a contact stands; the table at the top says what leads from one to the next.
enum class ContactMode : unsigned char { open, hovering, touching, closed, slack };

/// True of a contact that follows its law.
inline bool carries_force(ContactMode mode) {
  return mode == ContactMode::touching || mode == ContactMode::closed;
}

/// One mode per contact.
using ContactSet = std::vector<ContactMode>;

}  // namespace mariotte::contact
