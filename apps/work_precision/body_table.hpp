// The table of bodies: data/bodies.csv.
#pragma once
#include "problem.hpp"
#include "reference.hpp"

namespace mariotte::work_precision {

std::string name_of_body(const Fields& row);

Case body_impact(const Fields& row);

}  // namespace mariotte::work_precision
