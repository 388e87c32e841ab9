// Numbers of laws that no contact has.
#pragma once
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// Warns of keys that are said of all contacts of a chain, a network or bodies, and that none of the laws
/// there knows. All laws must have been read.
void warn_of_idle_keys(Source& source, const Field& whole);

}  // namespace mariotte::scene
