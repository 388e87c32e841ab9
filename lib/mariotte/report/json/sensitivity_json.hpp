// Slopes as JSON, table and CSV.
#pragma once
#include <string>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// Adds to a result: `parameters`, their names; `parameter_values`; `derivative`, by outcome one list of
/// slopes or one per element, a column per parameter, null where there is no slope; `swept_back`; and
/// `notes`.
void add_slopes(const impact::Sensitivity& slopes, Json& result);

/// A row per outcome and parameter, with slopes as they are and relative, (p/y) ∂y/∂p.
std::string table(const impact::Sensitivity& slopes, const std::string& title);

/// `outcome,value,unit`, then a column per parameter.
std::string csv(const impact::Sensitivity& slopes);

}  // namespace mariotte::report
