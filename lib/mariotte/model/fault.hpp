// What can be wrong with a model whose numbers are each possible.
#pragma once
#include "mariotte/core/fault.hpp"

namespace mariotte::fault {

inline constexpr Fault unrepresentable{"S035"};

}  // namespace mariotte::fault
