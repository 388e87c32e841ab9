// What can be wrong with an impact that laws are to be compared with.
#pragma once
#include "mariotte/core/fault.hpp"

namespace mariotte::fault {

inline constexpr Fault no_single_contact{"L006"};

}  // namespace mariotte::fault
