// Damped contacts that are followed to δ = 0 although their damper pulls there: the force c δ^q δ̇ with a
// small q stays until depths that no piece resolves, and falls to zero within them.
#pragma once
#include <span>

#include "mariotte/contact/law.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::impact {

/// A note by how much of their size slopes may be off for it, if that is more than the accuracy.
void note_late_damping(std::span<const contact::Law> laws, double accuracy, Sensitivity& slopes);

}  // namespace mariotte::impact
