#include "mariotte/impact/bodies/bodies_impact.hpp"

namespace mariotte::impact {
namespace {

/// Of all that may touch, what belongs to the contacts of the result.
std::vector<double> of_result(const BodiesImpact& impact, bool closed_alone, const std::vector<double>& all) {
  std::vector<double> some;
  for (const auto& one : impact.contacts)
    if (!closed_alone || !one.periods.empty()) some.push_back(all[one.contact]);
  return some;
}

}  // namespace

Trace contact_trace(const BodiesImpact& impact, bool closed_alone) {
  const auto& trace = impact.trace;
  Trace made{.time = trace.time, .velocity = {}, .gap = {}, .force = {}, .moving = "body"};
  for (const auto& bodies : trace.body) {
    auto& row = made.velocity.emplace_back();
    for (const auto& body : bodies) {
      row.insert(row.end(), {body.velocity.e1, body.velocity.e2});
      if (impact.dimension == 3) row.push_back(body.velocity.e3);
    }
  }
  for (const auto& row : trace.gap) made.gap.push_back(of_result(impact, closed_alone, row));
  for (const auto& row : trace.force) made.force.push_back(of_result(impact, closed_alone, row));
  return made;
}

}  // namespace mariotte::impact
