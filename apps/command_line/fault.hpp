// What can be wrong with a command line, or come of it.
#pragma once
#include "mariotte/scene/fault.hpp"

namespace mariotte::fault {

inline constexpr Fault unknown_argument{"U001"}, missing_argument{"U002"}, bad_argument{"U003"};
inline constexpr Fault law_incomplete{"L001"}, law_parameters{"L002"}, inadmissible{"L003"},
    no_icr_table{"L004"}, outside_table{"L005"};
inline constexpr Fault limit{"R001"}, invalid{"R004"};
inline constexpr Fault not_installed{"F004"};

}  // namespace mariotte::fault
