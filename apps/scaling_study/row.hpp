// The problem: a row of touching equal Hertz balls, k = m = 1, struck by the first at unit speed. Its ends do
// not depend on its length, so its error is known for any n.
#pragma once
#include <vector>

#include "mariotte/model/chain/chain.hpp"

namespace mariotte::scaling_study {

model::Chain row(std::size_t balls);

/// When the last contact opens; for 20 balls or more.
double end_time(std::size_t balls);

/// Largest error of the velocities of the first two and the last two balls; for 100 balls or more.
double error_of(const std::vector<double>& velocity);

}  // namespace mariotte::scaling_study
