// What can be wrong with a model whose numbers are each possible.
#pragma once
#include "mariotte/core/fault.hpp"

namespace mariotte::fault {

inline constexpr Fault unrepresentable{"S035"}, indeterminate{"S036"};

}  // namespace mariotte::fault
