// Contact laws in the units of a scale.
#pragma once
#include "mariotte/contact/law.hpp"
#include "mariotte/core/scale.hpp"

namespace mariotte::model {

/// k L^{n+1}/(M V²) and c L^n/(M V). Contacts with the reference's exponent divide by its stiffness instead
/// of going through L, which makes the reference's own stiffness exactly 1.
contact::Law scaled(const contact::Law& law, const Scale& scale, const contact::Law& reference);

}  // namespace mariotte::model
