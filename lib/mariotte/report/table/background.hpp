// The end of the table of a run in full: how far its model holds, how it was computed, what was not needed.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/flow_use.hpp"
#include "mariotte/impact/validity.hpp"

namespace mariotte::report {

/// A line per number that is known, with its limit and its `thing`, "contact" or "tip"; empty if none is.
std::string validity_table(const impact::Validity& validity, const char* thing);
std::string flows_table(const std::vector<impact::FlowUse>& flows);
std::string skipped_table(const std::vector<impact::Skipped>& skipped);

/// All three.
template <class Impact>
std::string background(const Impact& impact, const char* thing) {
  return validity_table(impact.validity, thing) + flows_table(impact.flows) + skipped_table(impact.skipped);
}

}  // namespace mariotte::report
