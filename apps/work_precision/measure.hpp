// One method over its ladder of tolerances on one problem.
#pragma once
#include <string>
#include <vector>

#include "measuring/timing.hpp"
#include "method.hpp"

namespace mariotte::work_precision {

/// How thorough a run is.
struct Effort {
  measuring::Patience patience;
  int decades;                       ///< between two tolerances of a ladder
  int doublings;                     ///< of the number of steps between two rungs of a fixed-step ladder
  std::size_t map_stride;            ///< only every so many-th point of a map along each axis
  measuring::Patience map_patience;  ///< of a pass over a map
};
Effort full_effort();
Effort quick_effort();

/// One point of a work–precision diagram; counts and times are per impact, of a map the mean.
struct Row {
  std::string problem;
  std::string method;
  Family family;
  double tolerance;  ///< asked for; of a fixed-step method the step
  double error;      ///< largest error of the final velocities
  double seconds;
  double rhs;
  double steps;
  double events;
  std::vector<double> errors;  ///< of every case
  bool told_periods;           ///< whether periods can be compared
  Index wrong_periods;         ///< cases in which a contact closed more or less often than it should
};

/// Points from the loosest setting to the tightest, until one takes too long. A setting at which the method
/// gives up is left out and said on stderr.
std::vector<Row> measure(const Problem& problem, const Method& method, const Effort& effort);

/// "problem,method,tolerance,error,seconds,rhs,steps,events", a line per row.
std::string csv(const std::vector<Row>& rows);

}  // namespace mariotte::work_precision
