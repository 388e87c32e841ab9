#include "mariotte/impact/bodies/bodies_frame.hpp"

#include <algorithm>

namespace mariotte::impact {
namespace {

Vector3 common_velocity(const MovingFrame& frame) {
  const auto [e1, e2, e3] = frame.velocity;
  return {e1, e2, e3};
}

/// Of mass centres, and of surfaces that spin.
double largest_speed(const model::Bodies& bodies) {
  double most = 0;
  for (const auto& body : bodies.body) {
    most = std::max(most, norm(body.velocity));
    for (const auto& sphere : body.spheres)
      most = std::max(most, norm(body.spin) * (norm(sphere.centre) + sphere.radius));
  }
  return most;
}

void leave(const Vector3& common, double time, std::vector<BodyEnd>& bodies) {
  for (auto& body : bodies) {
    body.position = body.position + time * common;
    body.velocity = body.velocity + common;
  }
}

}  // namespace

MovingFrame moving_frame(const model::Bodies& bodies) {
  if (bodies.body.empty() || !bodies.plane.empty() || norm(bodies.gravity) > 0) return {};
  const auto dimension = static_cast<std::size_t>(bodies.dimension);
  std::vector<double> velocity;
  for (const auto& body : bodies.body) {
    const double all[] = {body.velocity.e1, body.velocity.e2, body.velocity.e3};
    velocity.insert(velocity.end(), all, all + dimension);
  }
  auto frame = frame_of_first(velocity, dimension);
  if (frame) frame.share = largest_speed(within(frame, bodies)) / largest_speed(bodies);
  return frame;
}

model::Bodies within(const MovingFrame& frame, model::Bodies bodies) {
  const auto common = common_velocity(frame);
  if (frame)
    for (auto& body : bodies.body) body.velocity = body.velocity - common;
  return bodies;
}

void leave(const MovingFrame& frame, const model::Bodies& bodies, BodiesImpact& impact) {
  const auto common = common_velocity(frame);
  const auto gained = [&](const model::Body& body, const Vector3& velocity) {
    return body.mass * dot(common, velocity - 0.5 * common);
  };
  leave(common, impact.time, impact.body);
  for (std::size_t i = 0; i < impact.body.size(); ++i) {
    impact.energy.initial += gained(bodies.body[i], bodies.body[i].velocity);
    impact.energy.final += gained(bodies.body[i], impact.body[i].velocity);
  }
  for (std::size_t k = 0; k < impact.trace.time.size(); ++k)
    leave(common, impact.trace.time[k], impact.trace.body[k]);
  if (impact.estimated_accuracy) *impact.estimated_accuracy *= frame.share;
}

}  // namespace mariotte::impact
