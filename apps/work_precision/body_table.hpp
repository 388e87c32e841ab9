// The table of bodies: data/bodies.csv.
#pragma once
#include "measuring/reference_table.hpp"
#include "problem.hpp"

namespace mariotte::work_precision {

std::string name_of_body(const measuring::Fields& row);

Case body_impact(const measuring::Fields& row);

}  // namespace mariotte::work_precision
