#include "mariotte/impact/bodies/plane_motions.hpp"

namespace mariotte::impact {

std::vector<PlaneMotion> motions(const model::Bodies& bodies) {
  std::vector<PlaneMotion> list;
  for (const auto& body : bodies.body) list.push_back({body.velocity, body.spin.e3});
  return list;
}

double kinetic_energy(const model::Bodies& bodies, const std::vector<PlaneMotion>& motions) {
  double sum = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto& [velocity, spin] = motions[i];
    sum += 0.5 * (bodies.body[i].mass * dot(velocity, velocity) + bodies.body[i].inertia.e3 * spin * spin);
  }
  return sum;
}

}  // namespace mariotte::impact
