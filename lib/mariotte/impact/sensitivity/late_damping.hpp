// Damped contacts that end, or begin by another clock than their own, at δ = 0: the force c δ^q δ̇ with a
// small q stays until depths that no piece resolves, and falls to zero within them.
#pragma once
#include <span>

#include "mariotte/contact/law.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::impact {

/// By how much of their size slopes may be off where a law is followed to δ = 0 or from there; 0 without a
/// damper, and where its force jumps.
double lost_at_contact(const contact::Law& law);

/// Of laws that pull to δ = 0: a note by how much of their size slopes may be off for it, if that is more
/// than the accuracy.
void note_late_damping(std::span<const contact::Law> laws, double accuracy, Sensitivity& slopes);

}  // namespace mariotte::impact
