// Who is how much faster, at equal error.
#pragma once
#include <string>
#include <vector>

#include "measure.hpp"

namespace mariotte::work_precision {

/// A table for people: per problem and error the cheapest run time of `auto`, of SUNDIALS (rivals and our own
/// cvode flows), of odeint and of the fixed-step methods, and their ratios to that of `auto`.
std::string ratios(const std::vector<Row>& rows);

/// What accuracy was asked for and what was got over a map: per accuracy the share of points within it, the
/// worst error relative to it, and the points at which a contact closed more or less often than it should.
/// Empty if there is no row of a map.
std::string map_accuracy(const std::vector<Row>& rows);

}  // namespace mariotte::work_precision
