// What can be wrong with a sweep or a fit.
#pragma once
#include "mariotte/scene/fault.hpp"

namespace mariotte::fault {

inline constexpr Fault no_sweep{"W001"}, sweep_key{"W002"}, sweep_values{"W003"}, unknown_column{"W004"};
inline constexpr Fault foreign_journal{"W005"}, journal_in_use{"W006"};
inline constexpr Fault no_capture{"R003"};
inline constexpr Fault wrong_columns{"M002"}, too_few_rows{"M003"}, undetermined{"M004"}, no_minimum{"M005"};
inline constexpr Fault no_approach{"M006"};

}  // namespace mariotte::fault
