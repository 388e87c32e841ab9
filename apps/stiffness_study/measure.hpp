// The one place where the solver is called.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "impact_case.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::stiffness_study {

/// One impact by one flow.
struct Run {
  std::string ending = {};  ///< "separated", another ending, or "-" if it was not tried
  std::string reason = {};  ///< why it is not "separated"
  bool admitted = true;     ///< false if the flow asked for could follow nothing but a last single contact
  std::vector<std::string> flows = {};  ///< that followed contact phases
  Index steps = 0;
  Index rhs = 0;
  double seconds = 0;  ///< thread's CPU time of one solve with memory in place, least over batches
  std::vector<double> velocity = {};            ///< relative to the incident speed
  std::vector<std::optional<double>> icr = {};  ///< α_j = p_j/p_{j+1}
  std::vector<double> instants = {};            ///< of changes of the set of contacts after the onset, t/T

  bool separated() const { return ending == "separated"; }
};

/// How a run is asked for.
struct Request {
  std::string flow = "auto";
  double accuracy = 1e-10;
  double longest = infinity;  ///< stop at this multiple of the natural time
  bool brief = false;         ///< without flows and instants, whose watchers can cost more than the solution
  double batch =
      5e-3;  ///< CPU time of a timed batch [s]; 0 takes the time of the one run with all its reports
};

/// Never throws for what the solver does; a run that did not end well says so.
Run measure(const ImpactCase& one, const Request& request);

}  // namespace mariotte::stiffness_study
