// Uncertain outcomes as JSON and table.
#pragma once
#include <string>

#include "mariotte/report/json/json.hpp"
#include "mariotte/study/propagation/propagation.hpp"

namespace mariotte::report {

/// `ending`; `inputs` with key, value and deviation; `outcomes` with name, unit, value, deviation, the shares
/// of the inputs in its square and, if there are samples, mean and sampled_deviation; `samples`, `seed`,
/// `others`; and `notes`. null stands where there is no slope.
Json json(const study::Propagation& propagation);

/// A row per outcome, and the input that it owes most of its deviation to.
std::string table(const study::Propagation& propagation, const std::string& title);

}  // namespace mariotte::report
