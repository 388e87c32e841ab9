// What drives a chain or a network, as formulas.
#pragma once
#include <string>
#include <vector>

#include "mariotte/model/drives/drive.hpp"

namespace mariotte::report {

/// One line per piece of a signal; empty if there are no drives. What is driven is a `thing`, "ball" or
/// "degree of freedom", of so many velocities; of more than one the direction is shown.
std::string drive_table(const std::vector<model::Drive>& drives, const char* thing, Index dimension);

}  // namespace mariotte::report
