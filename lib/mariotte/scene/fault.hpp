// What can be wrong with a scene, and with the files that hold it or come of it.
#pragma once
#include "mariotte/core/fault.hpp"

namespace mariotte::fault {

// The text.
inline constexpr Fault not_toml{"S001"}, too_deep{"S002"};
// Its keys.
inline constexpr Fault unknown_key{"S010"}, missing{"S011"}, no_model{"S012"}, wrong_type{"S013"},
    contradiction{"S015"}, misplaced{"S016"}, leads_nowhere{"S017"};
// Its values, beside those of a single number.
inline constexpr Fault wrong_length{"S024"};
// What it describes.
inline constexpr Fault overlap{"S030"}, no_mass{"S031"}, no_stiffness{"S032"}, wrong_start{"S033"};
// Tables of measurements.
inline constexpr Fault no_table{"M001"};
// Files.
inline constexpr Fault unreadable{"F001"}, exists{"F002"}, unwritable{"F003"};

}  // namespace mariotte::fault
