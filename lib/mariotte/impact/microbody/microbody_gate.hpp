// What must hold when a microbody's run has come to an end.
#pragma once
#include <vector>

#include "mariotte/impact/gate.hpp"
#include "mariotte/model/microbody/microbody_system.hpp"

namespace mariotte::impact {

/// Of the run of a system from `start` to `end`, which ended in `mode`; dimensionless. Numbers are finite,
/// open tips above the plane, attitude a unit quaternion, and energy has not grown. If the state holds the
/// balance: energy is balanced, and no loss is below zero.
std::vector<Balance> balances(const model::MicrobodySystem& system, ConstState start, ConstState end,
                              const model::MicrobodyMode& mode);

}  // namespace mariotte::impact
