// What can be wrong with a sweep.
#pragma once
#include "mariotte/scene/fault.hpp"

namespace mariotte::fault {

inline constexpr Fault no_sweep{"W001"}, sweep_key{"W002"}, sweep_values{"W003"}, unknown_column{"W004"};
inline constexpr Fault foreign_journal{"W005"}, journal_in_use{"W006"};

}  // namespace mariotte::fault
