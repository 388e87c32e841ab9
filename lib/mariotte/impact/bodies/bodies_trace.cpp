#include "mariotte/impact/bodies/bodies_impact.hpp"

namespace mariotte::impact {

Trace contact_trace(const BodiesTrace& trace, int dimension) {
  Trace made{.time = trace.time, .velocity = {}, .gap = trace.gap, .force = trace.force, .moving = "body"};
  for (const auto& bodies : trace.body) {
    auto& row = made.velocity.emplace_back();
    for (const auto& body : bodies) {
      row.insert(row.end(), {body.velocity.e1, body.velocity.e2});
      if (dimension == 3) row.push_back(body.velocity.e3);
    }
  }
  return made;
}

}  // namespace mariotte::impact
